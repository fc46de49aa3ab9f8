// glTF: nodes, meshes, accessors, cameras and lights.

#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "gltf_fixture.h"

namespace tyndall {
namespace {

using nlohmann::json;
using Indices = std::vector<uint32_t>;

const std::vector<float> kSquare{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};

class GltfGeometry : public GltfTest {};

TEST_F(GltfGeometry, MakesWhatIsMissing) {
    GltfWriter writer;
    writer.triangle();
    const auto asset = load(writer);
    ASSERT_EQ(asset->nodes.size(), 1u);
    const Mesh& mesh = first_mesh(*asset).mesh;
    EXPECT_EQ(mesh.indices, (Indices{0, 1, 2}));
    EXPECT_EQ(mesh.normals, std::vector<glm::vec3>(3, glm::vec3(0, 0, 1)));
    ASSERT_EQ(mesh.tangents.size(), 3u);
    EXPECT_NEAR(glm::dot(glm::vec3(mesh.tangents[0]), mesh.normals[0]), 0.0f, 1e-6f);
    EXPECT_EQ(mesh.bounds.high, glm::vec3(1, 1, 0));
    EXPECT_TRUE(asset->warnings.empty());
    EXPECT_EQ(store_.gltf("file0.glb"), asset);
}

TEST_F(GltfGeometry, NormalsThatAreMissingAreFlat) {
    GltfWriter writer;  // two triangles that share an edge and meet at a right angle
    const int positions = writer.floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, -1}, "VEC3");
    writer.primitive({{"POSITION", positions}})["indices"] = writer.indices({0, 1, 2, 0, 2, 3});
    const Mesh mesh = first_mesh(*load(writer)).mesh;
    for (size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(glm::distance(mesh.normals[mesh.indices[i]], {0, 0, 1}), 0.0f, 1e-6f);
        EXPECT_NEAR(glm::distance(mesh.normals[mesh.indices[3 + i]], {-1, 0, 0}), 0.0f, 1e-6f);
    }
}

TEST_F(GltfGeometry, StripsAndFansBecomeTriangles) {
    GltfWriter writer;
    const int positions = writer.floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 2, 2, 0}, "VEC3");
    const int normals = writer.floats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    const json attributes{{"POSITION", positions}, {"NORMAL", normals}};
    writer.primitive(attributes)["mode"] = 5;
    writer.primitive(attributes)["mode"] = 6;
    json& indexed = writer.primitive(attributes);
    indexed["mode"] = 5;
    indexed["indices"] = writer.indices({4, 3, 2, 1});
    writer.root["scenes"][0]["nodes"] = {0, 1, 2};
    const auto asset = load(writer);
    const auto indices = [&](size_t node) { return asset->nodes.at(node).primitives.at(0).mesh->mesh.indices; };
    EXPECT_EQ(indices(0), (Indices{0, 1, 2, 1, 3, 2, 2, 3, 4}));
    EXPECT_EQ(indices(1), (Indices{1, 2, 0, 2, 3, 0, 3, 4, 0}));
    EXPECT_EQ(indices(2), (Indices{4, 3, 2, 3, 1, 2}));
}

TEST_F(GltfGeometry, PointsAndLinesAreNamed) {
    GltfWriter writer;
    writer.triangle();
    writer.root["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}, {"mode", 1}});
    const auto asset = load(writer);
    EXPECT_EQ(asset->nodes[0].primitives.size(), 1u);
    EXPECT_EQ(asset->warnings, std::vector<std::string>{"points and lines are ignored"});
}

TEST_F(GltfGeometry, InterleavedAndNormalisedValues) {
    GltfWriter writer;
    struct Vertex {
        float position[3];
        int8_t normal[4];
        uint16_t uv0[2];
        uint8_t uv1[4];
    };
    static_assert(sizeof(Vertex) == 24);
    const int view = writer.view_of(std::vector<Vertex>{{{0, 0, 0}, {0, 0, 127, 0}, {0, 65535}, {255, 51, 0, 0}},
                                                        {{1, 0, 0}, {0, -128, 0, 0}, {65535, 0}, {0, 0, 0, 0}},
                                                        {{0, 1, 0}, {0, 0, 127, 0}, {13107, 0}, {0, 0, 0, 0}}},
                                    sizeof(Vertex));
    const auto part = [&](int component, const char* type, int offset, bool normalised) {
        const int index = writer.accessor(view, component, type, 3);
        json& accessor = writer.root["accessors"][static_cast<size_t>(index)];
        accessor["byteOffset"] = offset;
        if (normalised) accessor["normalized"] = true;
        return index;
    };
    writer.primitive({{"POSITION", part(5126, "VEC3", 0, false)},
                      {"NORMAL", part(5120, "VEC3", 12, true)},
                      {"TEXCOORD_0", part(5123, "VEC2", 16, true)},
                      {"TEXCOORD_1", part(5121, "VEC2", 20, true)}});
    const Mesh mesh = first_mesh(*load(writer)).mesh;
    ASSERT_EQ(mesh.positions.size(), 3u);
    EXPECT_EQ(mesh.positions[2], glm::vec3(0, 1, 0));
    EXPECT_EQ(mesh.normals[1], glm::vec3(0, -1, 0)) << "-128 stands for -1";
    EXPECT_EQ(mesh.uv0[0], glm::vec2(0, 1));
    EXPECT_NEAR(mesh.uv0[2].x, 0.2f, 1e-6f);
    EXPECT_NEAR(mesh.uv1[0].y, 0.2f, 1e-6f);
}

TEST_F(GltfGeometry, SparseValuesTakeTheirPlaces) {
    GltfWriter writer;
    const int whole = writer.floats(kSquare, "VEC3");
    const json sparse{
        {"count", 2},
        {"indices", {{"bufferView", writer.view_of(std::vector<uint8_t>{1, 3})}, {"componentType", 5121}}},
        {"values", {{"bufferView", writer.view_of(std::vector<float>{7, 0, 0, 0, 8, 0})}}}};
    writer.root["accessors"][static_cast<size_t>(whole)]["sparse"] = sparse;
    writer.add("accessors", {{"componentType", 5126}, {"type", "VEC3"}, {"count", 4}, {"sparse", sparse}});
    const int indices = writer.indices({0, 1, 2, 2, 1, 3});
    writer.primitive({{"POSITION", whole}})["indices"] = indices;
    writer.primitive({{"POSITION", 1}})["indices"] = indices;
    writer.root["scenes"][0]["nodes"] = {0, 1};
    const auto asset = load(writer);
    const auto has = [&](size_t node, const glm::vec3& p) {
        const auto& positions = asset->nodes[node].primitives[0].mesh->mesh.positions;
        return std::ranges::find(positions, p) != positions.end();
    };
    EXPECT_TRUE(has(0, {7, 0, 0}) && has(0, {0, 8, 0}) && has(0, {0, 1, 0}) && !has(0, {1, 1, 0}));
    EXPECT_TRUE(has(1, {7, 0, 0}) && has(1, {0, 8, 0}) && has(1, {0, 0, 0}) && !has(1, {0, 1, 0}));
}

TEST_F(GltfGeometry, EveryReachPastAnEndIsAnError) {
    struct Case {
        const char* what;
        std::function<void(json&)> change;
    };
    const std::vector<Case> cases{
        {"past its buffer view", [](json& root) { root["accessors"][0]["count"] = 4; }},
        {"past its buffer view", [](json& root) { root["accessors"][0]["byteOffset"] = 4; }},
        {"past its buffer", [](json& root) { root["bufferViews"][0]["byteLength"] = 1000; }},
        {"past its buffer", [](json& root) { root["bufferViews"][0]["byteOffset"] = 4294967295u; }},
        {"no buffer 3", [](json& root) { root["bufferViews"][0]["buffer"] = 3; }},
        {"no buffer view 9", [](json& root) { root["accessors"][0]["bufferView"] = 9; }},
        {"no accessor 9", [](json& root) { root["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = 9; }},
        {"no material 5", [](json& root) { root["meshes"][0]["primitives"][0]["material"] = 5; }},
        {"no mesh 5", [](json& root) { root["nodes"][0]["mesh"] = 5; }},
        {"no scene 2", [](json& root) { root["scene"] = 2; }},
        {"too many",
         [](json& root) {
             root["accessors"][0] = {{"componentType", 5126}, {"type", "VEC3"}, {"count", 1000000000000}};
         }},
        {"components", [](json& root) { root["accessors"][0]["type"] = "VEC2"; }},
        {"unknown mode 9", [](json& root) { root["meshes"][0]["primitives"][0]["mode"] = 9; }},
    };
    for (const Case& test : cases) {
        GltfWriter writer;
        writer.triangle();
        test.change(writer.root);
        EXPECT_CONTAINS(error_of(writer), test.what);
    }
}

TEST_F(GltfGeometry, IndicesAndPositionsAreChecked) {
    GltfWriter writer;
    writer.triangle();
    writer.root["meshes"][0]["primitives"][0]["indices"] = writer.indices({0, 1, 3});
    EXPECT_CONTAINS(error_of(writer), "/meshes/0/primitives/0");
    GltfWriter nan;
    const int positions = nan.floats({0, 0, 0, 1, 0, 0, 0, std::numeric_limits<float>::quiet_NaN(), 0}, "VEC3");
    nan.primitive({{"POSITION", positions}});
    EXPECT_CONTAINS(error_of(nan), "finite");
}

TEST_F(GltfGeometry, NodesComeParentsFirst) {
    GltfWriter writer;
    writer.triangle();
    writer.root["nodes"] = {
        {{"name", "leaf"}, {"mesh", 0}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1}}},
        {{"name", "middle"},
         {"children", {0}},
         {"translation", {1, 2, 3}},
         {"rotation", {0, 0.70710678, 0, 0.70710678}},
         {"scale", {2, 3, 4}}},
        {{"name", "root"}, {"children", {1}}},
        {{"name", "outside"}}};
    writer.root["scenes"][0]["nodes"] = {2};
    const auto asset = load(writer);
    ASSERT_EQ(asset->nodes.size(), 3u);
    EXPECT_EQ(asset->nodes[0].name, "root");
    EXPECT_EQ(asset->nodes[1].name, "middle");
    EXPECT_EQ(asset->nodes[2].name, "leaf");
    EXPECT_EQ(asset->nodes[0].parent, -1);
    EXPECT_EQ(asset->nodes[1].parent, 0);
    EXPECT_EQ(asset->nodes[2].parent, 1);
    EXPECT_EQ(asset->nodes[2].local[3], glm::vec4(5, 6, 7, 1));
    const glm::vec4 p = asset->nodes[1].local * glm::vec4(1, 1, 1, 1);  // scaled, turned by 90 degrees about +Y, moved
    EXPECT_NEAR(glm::distance(p, glm::vec4(1 + 4, 2 + 3, 3 - 2, 1)), 0.0f, 1e-5f);
}

TEST_F(GltfGeometry, NodesThatAreNoTreeAreErrors) {
    const auto error = [&](json nodes, json roots) {
        GltfWriter writer;
        writer.root["nodes"] = std::move(nodes);
        writer.root["scenes"][0]["nodes"] = std::move(roots);
        writer.buffer = "....";
        return error_of(writer);
    };
    EXPECT_CONTAINS(error({{{"children", {1}}}, {{"children", {0}}}}, {0}), "own ancestor");
    EXPECT_CONTAINS(error({{{"children", {0}}}}, {0}), "own ancestor");
    EXPECT_CONTAINS(error({{{"children", {2}}}, {{"children", {2}}}, {{"name", "x"}}}, {0, 1}), "child of two nodes");
    EXPECT_CONTAINS(error({{{"children", {7}}}}, {0}), "no node 7");
    EXPECT_CONTAINS(error({{{"name", "x"}}}, {-1}), "no node -1");
    EXPECT_CONTAINS(error({{{"children", {1}}}, {{"name", "x"}}}, {1}), "child of another");
    EXPECT_CONTAINS(error({{{"rotation", {0, 0, 0, 0}}}}, {0}), "/nodes/0/rotation");
    EXPECT_CONTAINS(error({{{"scale", {1, 2}}}}, {0}), "/nodes/0/scale");
}

TEST_F(GltfGeometry, CamerasAndLights) {
    GltfWriter writer;
    writer.buffer = "....";
    writer.root["extensionsUsed"] = {"KHR_lights_punctual"};
    writer.root["cameras"] = {
        {{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.25}}}},
        {{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"zfar", 2}, {"znear", 1}}}}};
    writer.root["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "spot"},
         {"intensity", 40},
         {"color", {1, 0.5, 0.25}},
         {"range", 12},
         {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.3}}}},
        {{"type", "directional"}, {"intensity", 1000}},
        {{"type", "point"}}};
    const auto light = [](int index) { return json{{"extensions", {{"KHR_lights_punctual", {{"light", index}}}}}}; };
    writer.root["nodes"] = {{{"camera", 0}}, {{"camera", 1}}, light(0), light(1), light(2)};
    writer.root["scenes"][0]["nodes"] = {0, 1, 2, 3, 4};
    const auto asset = load(writer);
    ASSERT_TRUE(asset->nodes[0].camera);
    EXPECT_FLOAT_EQ(asset->nodes[0].camera->vertical_fov, 0.8f);
    EXPECT_FLOAT_EQ(asset->nodes[0].camera->near_m, 0.25f);
    EXPECT_FALSE(asset->nodes[1].camera);
    EXPECT_EQ(asset->warnings, std::vector<std::string>{"orthographic cameras are ignored"});
    const Light& spot = asset->nodes[2].light.value();
    EXPECT_EQ(spot.kind, LightKind::spot);
    EXPECT_NEAR(glm::distance(spot.intensity, {40, 20, 10}), 0.0f, 1e-3f);
    EXPECT_FLOAT_EQ(spot.range_m, 12.0f);
    EXPECT_FLOAT_EQ(spot.inner_angle, 0.1f);
    EXPECT_FLOAT_EQ(spot.outer_angle, 0.3f);
    EXPECT_EQ(asset->nodes[3].light.value().kind, LightKind::directional);
    EXPECT_NEAR(asset->nodes[3].light.value().intensity.y, 1000.0f, 0.1f);
    EXPECT_EQ(asset->nodes[4].light.value().kind, LightKind::point);
    EXPECT_NEAR(asset->nodes[4].light.value().intensity.x, 1.0f, 1e-4f);

    writer.root["extensions"]["KHR_lights_punctual"]["lights"][0]["spot"]["innerConeAngle"] = 0.4;
    EXPECT_CONTAINS(error_of(writer), "/extensions/KHR_lights_punctual/lights/0/spot");
    writer.root["nodes"][2] = light(9);
    EXPECT_CONTAINS(error_of(writer), "no light 9");
}

}  // namespace
}  // namespace tyndall
