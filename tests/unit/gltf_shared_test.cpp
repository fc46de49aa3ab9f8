// Files from other makers, and the project's own level.

#include <gtest/gtest.h>

#include <algorithm>

#include "color/color.h"
#include "core/paths.h"
#include "scene/asset_store.h"

namespace tyndall {
namespace {

struct Expected {
    const char* name;
    size_t triangles, materials, warnings;
};

class SharedGltf : public testing::TestWithParam<Expected> {};

TEST_P(SharedGltf, LoadsWithItsWarnings) {
    const std::filesystem::path folder = paths::root().parent_path() / "shared" / "assets" / "gltf";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
    const ColorConfig config;
    AssetStore store(config, folder);
    const auto asset = store.gltf(GetParam().name);
    size_t triangles = 0;
    std::vector<std::shared_ptr<const Material>> materials;
    for (size_t i = 0; i < asset->nodes.size(); ++i) {
        EXPECT_LT(asset->nodes[i].parent, static_cast<int>(i));
        for (const GltfNode::Primitive& primitive : asset->nodes[i].primitives) {
            triangles += primitive.mesh->mesh.triangle_count();
            EXPECT_EQ(primitive.mesh->mesh.normals.size(), primitive.mesh->mesh.positions.size());
            EXPECT_EQ(primitive.mesh->mesh.tangents.size(), primitive.mesh->mesh.positions.size());
            if (std::ranges::find(materials, primitive.material) == materials.end())
                materials.push_back(primitive.material);
        }
    }
    EXPECT_EQ(triangles, GetParam().triangles);
    EXPECT_EQ(materials.size(), GetParam().materials);
    EXPECT_EQ(asset->warnings.size(), GetParam().warnings) << testing::PrintToString(asset->warnings);
}

INSTANTIATE_TEST_SUITE_P(Files, SharedGltf,
                         testing::Values(Expected{"IridescentDishWithOlives.plain.glb", 24448, 4, 2},
                                         Expected{"mosquito-in-amber/scene.patched.gltf", 14349, 3, 1},
                                         Expected{"usd-shader-ball/usd-shaderball-ball.glb", 63856, 3, 1}),
                         [](const auto& info) { return "file_" + std::to_string(info.index); });

TEST(Chapel, Loads) {
    const ColorConfig config;
    AssetStore store(config, paths::root() / "assets" / "chapel");
    const auto chapel = store.gltf("chapel.glb");
    size_t triangles = 0;
    for (const GltfNode& node : chapel->nodes)
        for (const GltfNode::Primitive& primitive : node.primitives) {
            triangles += primitive.mesh->mesh.triangle_count();
            if (const auto& texture = primitive.material->base_colour_texture.texture) {
                EXPECT_TRUE(texture->srgb_encoded) << texture->name;
                EXPECT_EQ(texture->image.type, Image::Type::u8) << texture->name;
            }
        }
    EXPECT_GT(triangles, 100'000u);
    EXPECT_LT(triangles, 400'000u);
    EXPECT_TRUE(chapel->warnings.empty()) << testing::PrintToString(chapel->warnings);
}

}  // namespace
}  // namespace tyndall
