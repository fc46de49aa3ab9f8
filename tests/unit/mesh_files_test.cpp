#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <fstream>
#include <glm/geometric.hpp>
#include <random>

#include "core/error.h"
#include "geometry/mesh.h"
#include "geometry/polygons.h"
#include "temporary_folder.h"

namespace tyndall {
namespace fs = std::filesystem;
namespace {

const fs::path kShared = "../shared/assets/models";  // tests run from the project's root

constexpr std::string_view kObj = R"(# a pyramid with a quad for its base
mtllib /dev/zero
v 0 1 0
v -1 0 -1
v 1 0 -1
v 1 0 1
v -1 0 1
vt 0.5 1
vt 0 0
vt 1 0
vn 0 -1 0
f 1/1 5/2 4/3
f 1/1 4/2 3/3
f -5/1 -3/2 -4/3
f 1/1 2/2 \
  5/3
f 2/1/1 3/2/1 4/3/1 5/3/1
)";

constexpr std::string_view kOff = R"(OFF
4 4 6
0 0 0
1 0 0
0 1 0
0 0 1
3 0 2 1
3 0 1 3
3 0 3 2
3 1 2 3
)";

constexpr std::string_view kPly = R"(ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
property float nx
property float ny
property float nz
property float u
property float v
element face 2
property list uchar int vertex_indices
end_header
0 0 0 0 0 1 0 0
1 0 0 0 0 1 1 0
1 1 0 0 0 1 1 1
0 1 0 0 0 1 0 1
3 0 1 2
3 0 2 3
)";

constexpr std::string_view kStl = R"(solid two
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 0 0
vertex 1 1 0
endloop
endfacet
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 1 0
vertex 0 1 0
endloop
endfacet
endsolid two
)";

template <class T>
void append(std::string& to, T value) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    to.append(bytes, sizeof value);
}

/// The tetrahedron of kOff.
std::string binary_ply() {
    std::string out =
        "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
    for (const int v : {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}) append(out, static_cast<float>(v));
    for (int face = 0; face < 4; ++face) {
        constexpr int kFaces[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
        append(out, std::uint8_t{3});
        for (int i = 0; i < 3; ++i) append(out, kFaces[3 * face + i]);
    }
    return out;
}

std::string binary_stl() {
    std::string out(80, ' ');
    append(out, std::uint32_t{2});
    const float triangles[2][12] = {{0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 1, 0}, {0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 1, 0}};
    for (const auto& triangle : triangles) {
        for (const float v : triangle) append(out, v);
        append(out, std::uint16_t{0});
    }
    return out;
}

class MeshFiles : public TemporaryFolder {
 protected:
    fs::path file(const std::string& name, std::string_view content) {
        std::ofstream(folder_ / name, std::ios::binary) << content;
        return folder_ / name;
    }
    std::string message_of(const fs::path& path) {
        try {
            (void)load_mesh(path);
        } catch (const Error& error) {
            return error.what();
        }
        return {};
    }
};

bool contains(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

TEST_F(MeshFiles, Obj) {
    const PolygonMesh polygons = load_polygons(file("a.obj", kObj));
    EXPECT_EQ(polygons.positions.size(), 5u);
    EXPECT_EQ(polygons.positions[2], glm::vec3(1, 0, -1));
    EXPECT_EQ(polygons.face_sizes, (std::vector<std::uint32_t>{3, 3, 3, 3, 4}));
    EXPECT_EQ(polygons.corners[7], 2u);  // -3 is the third from the end
    EXPECT_EQ(polygons.uvs[0], glm::vec2(0.5f, 0)) << "v is counted from the top";
    EXPECT_TRUE(polygons.normal_corners.empty()) << "only one face has normals";
    const Mesh mesh = load_mesh(folder_ / "a.obj");
    EXPECT_EQ(mesh.triangle_count(), 6u);
    EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
    EXPECT_EQ(mesh.tangents.size(), mesh.positions.size());
    EXPECT_EQ(mesh.bounds.low, glm::vec3(-1, 0, -1));
    EXPECT_NO_THROW(validate(mesh, "a.obj"));
}

TEST_F(MeshFiles, ObjKeepsOneNormalForEachCorner) {
    const Mesh mesh = load_mesh(file("a.obj",
                                     "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 2\nvn 0 1 0\n"
                                     "f 1//1 2//1 3//1\nf 1//2 4//2 2//2\n"));
    ASSERT_EQ(mesh.positions.size(), 6u);
    EXPECT_EQ(mesh.normals[mesh.indices[0]], glm::vec3(0, 0, 1));  // made unit
    EXPECT_EQ(mesh.normals[mesh.indices[3]], glm::vec3(0, 1, 0));
}

TEST_F(MeshFiles, ObjErrorsHaveLines) {
    EXPECT_TRUE(contains(message_of(file("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n")),
                         "a.obj:4:1: a face names vertex 4 (expected 1 to 3)"));
    EXPECT_TRUE(contains(message_of(file("a.obj", "v 0 0\n")), "a.obj:1:1: a number is missing"));
    EXPECT_TRUE(contains(message_of(file("a.obj", "v 0 0 nan\n")), "'nan' is no number"));
    EXPECT_TRUE(contains(message_of(file("a.obj", "v 0 0 1e99\n")), "'1e99' is no number"));
    EXPECT_TRUE(contains(message_of(file("a.obj", "v 0 0 0\nf 1 1\n")), "a.obj:2:1: a face has 2 corners"));
    EXPECT_TRUE(contains(message_of(file("a.obj", "v 0 0 0\nf 1//7 1//7 1//7\n")), "names normal 7"));
    EXPECT_TRUE(contains(message_of(file("a.obj", "v 0 0 0\nf 0 0 0\n")), "names vertex 0"));
    EXPECT_TRUE(contains(message_of(file("a.obj", "v 0 0 0\nf -2 1 1\n")), "names vertex -2"));
    EXPECT_TRUE(contains(message_of(file("a.obj", "v 0 0 0\nf 1x 1 1\n")), "'1x' is no whole number"));
    EXPECT_TRUE(contains(message_of(file("a.obj", "v 0 0 0\n")), "no faces"));
    EXPECT_TRUE(contains(message_of(file("a.obj", "# nothing\n")), "no vertices"));
}

TEST_F(MeshFiles, PlyOffStl) {
    const Mesh off = load_mesh(file("a.off", kOff));
    EXPECT_EQ(off.triangle_count(), 4u);
    const Mesh ply = load_mesh(file("a.ply", kPly));
    EXPECT_EQ(ply.positions.size(), 4u);
    ASSERT_EQ(ply.uv0.size(), 4u);
    EXPECT_EQ(ply.uv0[2], glm::vec2(1, 0));
    EXPECT_EQ(ply.normals[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(load_mesh(file("b.ply", binary_ply())).indices, off.indices);
    for (const auto& [name, content] : {std::pair{"a.stl", std::string(kStl)}, {"b.stl", binary_stl()}}) {
        const Mesh stl = load_mesh(file(name, content));
        EXPECT_EQ(stl.triangle_count(), 2u) << name;
        EXPECT_EQ(stl.positions.size(), 4u) << "corners in the same place are joined";
    }
}

TEST_F(MeshFiles, ErrorsNameTheFile) {
    EXPECT_TRUE(contains(message_of(folder_ / "none.obj"), "none.obj"));
    EXPECT_TRUE(contains(message_of(file("a.objj", kObj)), "did you mean '.obj'?"));
    for (const char* name : {"e.obj", "e.ply", "e.off", "e.stl"}) {
        EXPECT_TRUE(contains(message_of(file(name, "")), std::string(name) + ": the file is empty"));
        EXPECT_TRUE(contains(message_of(file(name, "I am a poem\n")), name)) << message_of(folder_ / name);
    }
    std::string far = binary_ply();
    far[far.size() - 2] = 1;  // an index of 65539
    EXPECT_TRUE(contains(message_of(file("far.ply", far)), "far.ply: a face names vertex 65539 of 4"));
    std::string nan = binary_ply();
    nan[nan.find("end_header\n") + 11 + 3] = '\x7f';
    nan[nan.find("end_header\n") + 11 + 2] = '\xc0';
    EXPECT_TRUE(contains(message_of(file("nan.ply", nan)), "nan.ply: the position of vertex 0 is not finite"));
}

/// Cut files are refused; mutated ones load or are refused. Nothing crashes, hangs or writes to the terminal.
TEST_F(MeshFiles, BrokenFilesAreErrors) {
    std::mt19937 random(13);
    const std::pair<const char*, std::string> files[] = {{"a.obj", std::string(kObj)}, {"a.off", std::string(kOff)},
                                                         {"a.ply", std::string(kPly)}, {"b.ply", binary_ply()},
                                                         {"a.stl", std::string(kStl)}, {"b.stl", binary_stl()}};
    for (const auto& [name, whole] : files) {
        for (size_t i = 1; i < 24; ++i) {
            const std::string cut = whole.substr(0, whole.size() * i / 24);
            const std::string message = message_of(file(name, cut));
            const bool may_end_anywhere = std::string_view(name) == "a.obj";  // after any line
            EXPECT_TRUE(may_end_anywhere || contains(message, name)) << name << " cut at " << i << "/24";
        }
        for (int i = 0; i < 300; ++i) {
            std::string mutated = whole;
            for (int k = 0; k < 3; ++k) mutated[random() % mutated.size()] = static_cast<char>(random());
            const std::string message = message_of(file(name, mutated));
            EXPECT_TRUE(message.empty() || contains(message, name)) << message;
        }
    }
}

TEST_F(MeshFiles, RealModelsLoad) {
    if (!fs::exists(kShared)) GTEST_SKIP() << "no " << kShared << ": real models are not loaded";
    const std::pair<const char*, size_t> models[] = {{"dragon_100k.obj", 100000}, {"buddha_100k.obj", 100000},
                                                     {"Lucy100k.ply", 100000},    {"mitsuba_bunny.ply", 69451},
                                                     {"armadillo.off", 52000},    {"spot/spot_triangulated.obj", 5856}};
    for (const auto& [name, least] : models) {
        const auto start = std::chrono::steady_clock::now();
        const Mesh mesh = load_mesh(kShared / name);
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        RecordProperty(name, std::to_string(seconds));
        std::printf("%-28s %7zu triangles %7zu vertices %6.3f s\n", name, mesh.triangle_count(), mesh.positions.size(),
                    seconds);
        EXPECT_NEAR(static_cast<double>(mesh.triangle_count()), static_cast<double>(least),
                    0.05 * static_cast<double>(least));
        EXPECT_NO_THROW(validate(mesh, name));
        for (size_t i = 0; i < mesh.positions.size(); ++i) {
            ASSERT_NEAR(glm::length(mesh.normals[i]), 1, 1e-4f);
            ASSERT_NEAR(glm::dot(mesh.normals[i], glm::vec3(mesh.tangents[i])), 0, 1e-4f);
        }
    }
}

}  // namespace
}  // namespace tyndall
