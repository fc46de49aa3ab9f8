// Where media are and how much of them: masks of meshes, particles, sequences of volumes.

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <thread>

#include "color/color.h"
#include "core/error.h"
#include "core/paths.h"
#include "scene/mesh_mask.h"
#include "scene/primitives.h"
#include "scene/scattering_components.h"
#include "scene/volume_stream.h"
#include "temporary_folder.h"

namespace tyndall {
namespace {

template <class F>
std::string error_of(F action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

void expect_parts(const std::string& text, std::initializer_list<const char*> parts) {
    for (const char* part : parts) EXPECT_NE(text.find(part), std::string::npos) << part << "\nin: " << text;
}

/// Sum of values times a voxel's volume.
double amount(const Volume& volume) {
    double sum = 0.0;
    for (const float value : volume.values) sum += double(value);
    return sum * double(volume.voxel_m.x) * double(volume.voxel_m.y) * double(volume.voxel_m.z);
}

TEST(MeshMask, HoldsTheVolumeOfClosedMeshes) {
    const Volume ball = voxelised(make_primitive(Primitive::sphere, 64), 40, "ball");
    std::printf("ball: %.5f of %.5f\n", amount(ball), std::numbers::pi / 6.0);
    EXPECT_NEAR(amount(ball) / (std::numbers::pi / 6.0), 1.0, 0.01);
    const Volume box = voxelised(make_primitive(Primitive::box, 3), 20, "box");
    EXPECT_NEAR(amount(box), 1.0, 0.02);
    EXPECT_EQ(box.at(box.size.x / 2, box.size.y / 2, box.size.z / 2), 1.0f);
    EXPECT_EQ(box.at(0, 0, 0), 0.0f);
    const Volume cylinder = voxelised(make_primitive(Primitive::cylinder, 64), 40, "cylinder");
    EXPECT_NEAR(amount(cylinder) / (std::numbers::pi / 4.0), 1.0, 0.015);
}

TEST(MeshMask, LiesWhereTheMeshLies) {
    Mesh mesh = make_primitive(Primitive::sphere, 32);
    for (glm::vec3& p : mesh.positions) p = p * glm::vec3(2.0f, 1.0f, 4.0f) + glm::vec3(10.0f, -3.0f, 5.0f);
    mesh.bounds = bounds_of(mesh.positions);
    const Volume volume = voxelised(mesh, 32, "egg");
    const glm::vec3 middle = volume.low_m + 0.5f * glm::vec3(volume.size) * volume.voxel_m;
    EXPECT_NEAR(middle.x, 10.0f, 1e-4f);
    EXPECT_NEAR(middle.y, -3.0f, 1e-4f);
    EXPECT_NEAR(middle.z, 5.0f, 1e-4f);
    EXPECT_NEAR(volume.voxel_m.z, 4.0f / 32.0f, 1e-5f);
}

TEST(MeshMask, SaysWhichMeshIsNotClosed) {
    EXPECT_EQ(open_edges(make_primitive(Primitive::sphere, 16)), 0u);
    EXPECT_EQ(open_edges(make_primitive(Primitive::box, 3)), 0u);
    EXPECT_EQ(open_edges(make_primitive(Primitive::plane, 3)), 4u);
    Mesh broken = make_primitive(Primitive::sphere, 16);
    broken.indices.resize(broken.indices.size() - 300);
    EXPECT_GT(open_edges(broken), 0u);
    expect_parts(error_of([&] { (void)voxelised(broken, 16, "shell.ply"); }),
                 {"shell.ply", "not closed", "open edges"});
    expect_parts(error_of([&] { (void)voxelised(Mesh{}, 16, "void.ply"); }), {"void.ply", "no triangles"});
}

/// The integral of (1 - (r / R)^2)^2 over a ball.
double ball_amount(double radius) {
    return 4.0 * std::numbers::pi * radius * radius * radius * (1.0 / 3.0 - 2.0 / 5.0 + 1.0 / 7.0);
}

TEST(Particles, AddUpAndKeepTheirAmount) {
    const std::vector<Particle> two = {{{0, 0, 0}, 0.5f, 1.0f}, {{0.4f, 0.1f, 0}, 0.3f, 2.0f}};
    const Volume volume = rasterised(two, 48);
    EXPECT_NEAR(amount(volume) / (ball_amount(0.5) + 2.0 * ball_amount(0.3)), 1.0, 0.005);
    // a mist of balls far smaller than a voxel
    std::vector<Particle> mist;
    for (int i = 0; i < 1000; ++i)
        mist.push_back({{0.1f * float(i % 10), 0.1f * float(i / 10 % 10), 0.1f * float(i / 100)}, 0.004f, 1.0f});
    EXPECT_NEAR(amount(rasterised(mist, 16)) / (1000 * ball_amount(0.004)), 1.0, 0.1);
}

TEST(Particles, WithoutAnyThereIsAMessage) {
    const float infinite = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<Particle> none,
        bad = {{{0, 0, 0}, 0.0f, 1.0f}, {{0, nan, 0}, 1.0f, 1.0f}, {{infinite, 0, 0}, 1.0f, 1.0f}};
    expect_parts(error_of([&] { (void)rasterised(none, 16); }), {"no particles"});
    expect_parts(error_of([&] { (void)rasterised(bad, 16); }), {"no particles"});
}

class MediaFiles : public TemporaryFolder {
 protected:
    void SetUp() override {
        TemporaryFolder::SetUp();
        assets_ = std::make_unique<AssetStore>(config_, folder_);
    }
    void write(const std::string& name, const std::string& content) {
        std::ofstream(folder_ / name, std::ios::binary) << content;
    }
    /// A raw volume of 2^3 voxels, all of one value, in a file of the sequence.
    void write_frame(int number, int value) {
        const std::string name = "f_0" + std::to_string(number);
        write(name + ".raw", std::string(8, static_cast<char>(value)));
        write(name + ".json", R"({"raw": ")" + name + R"(.raw", "type": "u8", "size": [2, 2, 2]})");
    }
    static VolumeSequence sequence() {
        VolumeSequence s{.file = "f_##.json", .grid = ""};
        s.first = 1, s.last = 4, s.frames_per_s = 10.0f;
        return s;
    }

    ColorConfig config_{paths::root() / "config" / "color" / "tyndall.ocio"};
    std::unique_ptr<AssetStore> assets_;
};

TEST_F(MediaFiles, ParticlesComeFromTextAndPly) {
    write("p.txt", "# drops\n0 0 0\n1, 2, 3, 0.5\n\n4 5 6 0.25 2 # heavy\n");
    const auto text = assets_->particles("p.txt");
    ASSERT_EQ(text->particles.size(), 3u);
    EXPECT_EQ(text->particles[0].radius_m, 0.0f) << "none of its own";
    EXPECT_EQ(text->particles[1].centre, glm::vec3(1, 2, 3));
    EXPECT_EQ(text->particles[2].weight, 2.0f);
    write("p.ply",
          "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n"
          "property float radius\nend_header\n1 2 3 0.5\n4 5 6 0.7\n");
    const auto ply = assets_->particles("p.ply");
    ASSERT_EQ(ply->particles.size(), 2u);
    EXPECT_EQ(ply->particles[1].centre, glm::vec3(4, 5, 6));
    EXPECT_EQ(ply->particles[1].radius_m, 0.7f);
}

TEST_F(MediaFiles, BrokenParticlesAreReportedByLine) {
    write("bad.txt", "0 0 0 1\n0 zero 0 1\n");
    write("short.txt", "0 0\n");
    write("empty.txt", "# nothing\n");
    write("nan.ply",
          "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float "
          "z\nend_header\nnan 2 3\n");
    expect_parts(error_of([&] { (void)assets_->particles("bad.txt"); }), {"bad.txt:2", "'zero'"});
    expect_parts(error_of([&] { (void)assets_->particles("short.txt"); }), {"short.txt:1", "x y z"});
    expect_parts(error_of([&] { (void)assets_->particles("empty.txt"); }), {"empty.txt", "no particles"});
    expect_parts(error_of([&] { (void)assets_->particles("nan.ply"); }), {"nan.ply"});
    expect_parts(error_of([&] { (void)assets_->particles("none.txt"); }), {"none.txt"});
}

TEST_F(MediaFiles, MasksAreMadeOnce) {
    const MeshAsset ball{.id = new_asset_id(), .name = "ball", .mesh = make_primitive(Primitive::sphere, 16)};
    const auto mask = assets_->mesh_mask(ball, 12);
    EXPECT_EQ(assets_->mesh_mask(ball, 12), mask);
    EXPECT_NE(assets_->mesh_mask(ball, 13), mask);
    const std::vector<Particle> one = {{{0, 0, 0}, 0.5f, 1.0f}};
    const auto drop = assets_->particle_mask(one, 8);
    EXPECT_EQ(assets_->particle_mask(one, 8), drop);
}

TEST(Sequence, ShowsEachFrameInItsTime) {
    VolumeSequence s{.file = "smoke_####.vdb", .grid = "density"};
    s.first = 30, s.last = 70, s.step = 20, s.frames_per_s = 10.0f, s.start_s = 1.0f;
    EXPECT_EQ(frame_count(s), 3);
    EXPECT_EQ(frame_name(s, 0), "smoke_0030.vdb");
    EXPECT_EQ(frame_name(s, 2), "smoke_0070.vdb");
    EXPECT_EQ(frame_at(s, -5.0), 0);
    EXPECT_EQ(frame_at(s, 1.05), 0);
    EXPECT_EQ(frame_at(s, 1.1), 1);
    EXPECT_EQ(frame_at(s, 1.2999), 2);
    EXPECT_EQ(frame_at(s, 1.3), 0) << "from the start again";
    s.playback = Playback::hold;
    EXPECT_EQ(frame_at(s, 99.0), 2);
    EXPECT_EQ(frame_after(s, 2), 2);
    EXPECT_EQ(frame_at(s, 1e300), 2);
    s.file = "one.vdb";
    EXPECT_EQ(frame_name(s, 1), "one.vdb");
}

TEST_F(MediaFiles, PicturesWaitForTheFrameOfTheirTime) {
    for (int i = 1; i <= 4; ++i) write_frame(i, 50 * i);
    for (const int index : {0, 2, 1, 3, 0}) {
        const auto frame = assets_->sequence_frame(sequence(), index);
        ASSERT_TRUE(frame);
        EXPECT_NEAR(frame->volume.values[0], float(50 * (index + 1)) / 255.0f, 1e-6f);
    }
    EXPECT_EQ(assets_->sequence_frame(sequence(), 1), assets_->sequence_frame(sequence(), 1)) << "kept";
}

TEST_F(MediaFiles, GamesGoOnWithTheLastGoodFrame) {
    write_frame(1, 51);
    write_frame(3, 153);
    write("f_02.json", "{ broken");  // and the fourth is not there
    assets_->set_streaming(true);
    std::shared_ptr<const VolumeAsset> frame;
    const auto start = std::chrono::steady_clock::now();
    while (!frame && std::chrono::steady_clock::now() - start < std::chrono::seconds(20)) {
        frame = assets_->sequence_frame(sequence(), 0);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ASSERT_TRUE(frame) << "it comes, in the background";
    EXPECT_NEAR(frame->volume.values[0], 0.2f, 1e-6f);
    EXPECT_EQ(assets_->sequence_frame(sequence(), 1), frame) << "the second is broken";
    assets_->set_streaming(false);
    expect_parts(error_of([&] { (void)assets_->sequence_frame(sequence(), 1); }), {"f_02.json"});
    expect_parts(error_of([&] { (void)assets_->sequence_frame(sequence(), 3); }), {"f_04.json"});
    EXPECT_NEAR(assets_->sequence_frame(sequence(), 2)->volume.values[0], 0.6f, 1e-6f);
}

TEST_F(MediaFiles, GridsOfAFileKeepTheirPlaces) {
    // two volumes of one space: the second fills the upper half of the first's box
    auto made = [&](const std::string& name, glm::ivec3 size) {
        write(name + ".raw", std::string(size_t(size.x * size.y * size.z), '\xff'));
        write(name + ".json", R"({"raw": ")" + name + R"(.raw", "type": "u8", "size": [)" + std::to_string(size.x) +
                                  ", " + std::to_string(size.y) + ", " + std::to_string(size.z) + "]}");
    };
    made("all", {4, 4, 4});
    VolumeDensity density;
    density.file = "all.json";
    density.low_m = {0, 0, 0};
    density.high_m = {8, 4, 4};  // twice as wide as the file's box: it fills the lower half of x
    const VolumePlace place{{glm::vec3(-0.5f), glm::vec3(0.5f)}, glm::mat4(1.0f), 0.0};
    const GridDensity grid = placed_volume(density, "", *assets_, place);
    const glm::vec3 left(grid.to_volume * glm::vec4(-0.5f, -0.5f, -0.5f, 1.0f));
    const glm::vec3 middle(grid.to_volume * glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
    EXPECT_NEAR(left.x, 0.0f, 1e-6f);
    EXPECT_NEAR(middle.x, 1.0f, 1e-6f);
    EXPECT_NEAR(middle.y, 0.5f, 1e-6f);
    density.high_m = {8, -4, 4};
    expect_parts(error_of([&] { (void)placed_volume(density, "", *assets_, place); }), {"high_m"});
    density.file.clear();
    expect_parts(error_of([&] { (void)placed_volume(density, "", *assets_, place); }), {"needs a file"});
}

}  // namespace
}  // namespace tyndall
