// glTF: materials, textures, extensions, files beside the file, and reloading.

#include <chrono>
#include <numbers>
#include <thread>

#include "gltf_fixture.h"

namespace tyndall {
namespace {

using nlohmann::json;

class GltfMaterial : public GltfTest {
 protected:
    /// A texture of a PNG inside the buffer.
    int texture(GltfWriter& writer, const std::string& picture, json more = json::object()) {
        more["source"] = writer.add(
            "images", {{"bufferView", writer.view(picture)}, {"mimeType", "image/png"}, {"name", "picture"}});
        return writer.add("textures", more);
    }
};

TEST_F(GltfMaterial, TheDefaultIsGltfs) {
    GltfWriter writer;
    writer.primitive({{"POSITION", writer.floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3")}});
    const auto asset = load(writer);
    const Material& material = first_material(*asset);
    EXPECT_FLOAT_EQ(material.metallic, 1.0f);
    EXPECT_FLOAT_EQ(material.roughness, 1.0f);
    EXPECT_NEAR(glm::distance(material.base_colour, glm::vec4(1.0f)), 0.0f, 1e-5f);
    EXPECT_EQ(material.emissive, glm::vec3(0.0f));
    EXPECT_NE(material.id, 0u);
}

TEST_F(GltfMaterial, EveryFactorArrives) {
    GltfWriter writer;
    writer.triangle(
        {{"name", "glass"},
         {"pbrMetallicRoughness",
          {{"baseColorFactor", {0.25, 0.5, 0.75, 0.5}}, {"metallicFactor", 0.1}, {"roughnessFactor", 0.2}}},
         {"emissiveFactor", {1, 0.5, 0.25}},
         {"alphaMode", "MASK"},
         {"alphaCutoff", 0.3},
         {"doubleSided", true},
         {"extensions",
          {{"KHR_materials_emissive_strength", {{"emissiveStrength", 200}}},
           {"KHR_materials_ior", {{"ior", 1.33}}},
           {"KHR_materials_specular", {{"specularFactor", 0.5}, {"specularColorFactor", {0.5, 1, 2}}}},
           {"KHR_materials_transmission", {{"transmissionFactor", 0.9}}},
           {"KHR_materials_diffuse_transmission",
            {{"diffuseTransmissionFactor", 0.4}, {"diffuseTransmissionColorFactor", {0.5, 0.25, 0.75}}}},
           {"KHR_materials_volume",
            {{"thicknessFactor", 0.02}, {"attenuationColor", {0.1, 0.2, 0.3}}, {"attenuationDistance", 4}}}}}});
    const auto asset = load(writer);
    const Material& m = first_material(*asset);
    EXPECT_CONTAINS(m.name, "glass");
    const auto near = [](const glm::vec3& a, const glm::vec3& b) {
        return glm::distance(a, b) < 1e-4f * glm::length(b);
    };
    EXPECT_TRUE(near(glm::vec3(m.base_colour), {0.25f, 0.5f, 0.75f}));
    EXPECT_FLOAT_EQ(m.base_colour.w, 0.5f);
    EXPECT_FLOAT_EQ(m.metallic, 0.1f);
    EXPECT_FLOAT_EQ(m.roughness, 0.2f);
    EXPECT_TRUE(near(m.emissive, {200, 100, 50})) << "cd/m2";
    EXPECT_EQ(m.alpha_mode, AlphaMode::mask);
    EXPECT_FLOAT_EQ(m.alpha_cutoff, 0.3f);
    EXPECT_TRUE(m.double_sided);
    EXPECT_FLOAT_EQ(m.ior, 1.33f);
    EXPECT_FLOAT_EQ(m.specular, 0.5f);
    EXPECT_TRUE(near(m.specular_colour, {0.5f, 1, 2}));
    EXPECT_FLOAT_EQ(m.transmission, 0.9f);
    EXPECT_FLOAT_EQ(m.diffuse_transmission, 0.4f);
    EXPECT_TRUE(near(m.diffuse_transmission_colour, {0.5f, 0.25f, 0.75f}));
    EXPECT_FLOAT_EQ(m.thickness_m, 0.02f);
    EXPECT_TRUE(near(m.attenuation_colour, {0.1f, 0.2f, 0.3f}));
    EXPECT_FLOAT_EQ(m.attenuation_distance_m, 4.0f);
    EXPECT_TRUE(asset->warnings.empty());
}

TEST_F(GltfMaterial, WhatIsOutOfRangeIsMovedThereAndSaid) {
    GltfWriter writer;
    writer.triangle({{"pbrMetallicRoughness", {{"roughnessFactor", 7}}}});
    const auto asset = load(writer);
    EXPECT_FLOAT_EQ(first_material(*asset).roughness, 1.0f);
    ASSERT_EQ(asset->warnings.size(), 1u);
    EXPECT_CONTAINS(asset->warnings[0], "/materials/0/roughnessFactor");
    GltfWriter wrong;
    wrong.triangle({{"alphaMode", "BLUR"}});
    EXPECT_CONTAINS(error_of(wrong), "/materials/0/alphaMode: unknown mode 'BLUR'");
}

TEST_F(GltfMaterial, ColoursAndDataAreToldApart) {
    GltfWriter writer;
    const int shared = texture(writer, png(200, 100, 50));
    writer.triangle({{"pbrMetallicRoughness",
                      {{"baseColorTexture", {{"index", shared}, {"texCoord", 1}}},
                       {"metallicRoughnessTexture", {{"index", shared}}}}},
                     {"occlusionTexture", {{"index", shared}, {"strength", 0.5}}},
                     {"normalTexture", {{"index", shared}, {"scale", 0.25}}},
                     {"emissiveTexture", {{"index", shared}}},
                     {"extensions",
                      {{"KHR_materials_specular", {{"specularColorTexture", {{"index", shared}}}}},
                       {"KHR_materials_diffuse_transmission",
                        {{"diffuseTransmissionTexture", {{"index", shared}}},
                         {"diffuseTransmissionColorTexture", {{"index", shared}}}}}}}});
    const auto asset = load(writer);
    const Material& m = first_material(*asset);
    const TextureAsset& colour = *m.base_colour_texture.texture;
    const TextureAsset& data = *m.metallic_roughness_texture.texture;
    EXPECT_TRUE(colour.srgb_encoded);
    EXPECT_EQ(colour.image.type, Image::Type::u8);
    EXPECT_FALSE(data.srgb_encoded);
    EXPECT_EQ(data.image.bytes()[0], 200);
    EXPECT_NE(colour.id, data.id);
    EXPECT_EQ(m.emissive_texture.texture.get(), &colour);
    EXPECT_EQ(m.specular_colour_texture.texture.get(), &colour);
    EXPECT_EQ(m.diffuse_transmission_texture.texture.get(), &data);
    EXPECT_EQ(m.diffuse_transmission_colour_texture.texture.get(), &colour);
    EXPECT_EQ(m.occlusion_texture.texture.get(), &data) << "one asset for each use, not for each slot";
    EXPECT_EQ(m.normal_texture.texture.get(), &data);
    EXPECT_EQ(m.base_colour_texture.uv_set, 1);
    EXPECT_FLOAT_EQ(m.occlusion_strength, 0.5f);
    EXPECT_FLOAT_EQ(m.normal_scale, 0.25f);
}

TEST_F(GltfMaterial, SamplersSayHowToLook) {
    GltfWriter writer;
    const std::string picture = png(1, 2, 3);
    const int image = writer.add("images", {{"bufferView", writer.view(picture)}, {"mimeType", "image/png"}});
    writer.root["samplers"] = {{{"magFilter", 9728}, {"minFilter", 9987}, {"wrapS", 33071}, {"wrapT", 33648}},
                               {{"magFilter", 9729}, {"minFilter", 9729}},
                               {{"wrapS", 1}}};
    for (int sampler = 0; sampler < 2; ++sampler) writer.add("textures", {{"source", image}, {"sampler", sampler}});
    writer.triangle({{"normalTexture", {{"index", 0}}}, {"occlusionTexture", {{"index", 1}}}});
    const auto asset = load(writer);
    const TextureAsset& first = *first_material(*asset).normal_texture.texture;
    const TextureAsset& second = *first_material(*asset).occlusion_texture.texture;
    EXPECT_EQ(first.filter, TextureFilter::nearest);
    EXPECT_EQ(first.wrap_u, TextureWrap::clamp);
    EXPECT_EQ(first.wrap_v, TextureWrap::mirror);
    EXPECT_EQ(second.filter, TextureFilter::linear);
    EXPECT_EQ(second.wrap_u, TextureWrap::repeat);
    EXPECT_EQ(first.image.pixels, second.image.pixels);
    writer.root["textures"][0]["sampler"] = 2;
    EXPECT_CONTAINS(error_of(writer), "/samplers/2");
    writer.root["textures"][0]["sampler"] = 3;
    EXPECT_CONTAINS(error_of(writer), "no sampler 3");
}

TEST_F(GltfMaterial, TextureTransforms) {
    GltfWriter writer;
    const int index = texture(writer, png(1, 2, 3));
    const json moved{
        {"index", index},
        {"extensions",
         {{"KHR_texture_transform",
           {{"offset", {0.1, 0.2}}, {"rotation", std::numbers::pi / 2}, {"scale", {2, 3}}, {"texCoord", 1}}}}}};
    writer.triangle(
        {{"normalTexture", moved}, {"extensions", {{"KHR_materials_transmission", {{"transmissionTexture", moved}}}}}});
    const auto asset = load(writer);
    for (const TextureSlot& slot :
         {first_material(*asset).normal_texture, first_material(*asset).transmission_texture}) {
        EXPECT_EQ(slot.uv_set, 1);
        // Scaled to (2, 0), turned counter-clockwise where V points down, then moved.
        const glm::vec3 uv = slot.uv_transform * glm::vec3(1, 0, 1);
        EXPECT_NEAR(glm::distance(uv, {0.1f, 0.2f - 2.0f, 1.0f}), 0.0f, 1e-5f);
        const glm::vec3 other = slot.uv_transform * glm::vec3(0, 1, 1);
        EXPECT_NEAR(glm::distance(other, {0.1f + 3.0f, 0.2f, 1.0f}), 0.0f, 1e-5f);
    }
}

TEST_F(GltfMaterial, PicturesComeFromFilesAndDataUris) {
    std::filesystem::create_directories(folder_ / "sub");
    write("sub/my picture.png", png(10, 20, 30));
    GltfWriter writer;
    writer.add("images", {{"uri", "sub/my%20picture.png"}});
    writer.add("images", {{"uri", "data:image/png;base64," + GltfWriter::base64(png(40, 50, 60))}});
    writer.add("textures", {{"source", 0}});
    writer.add("textures", {{"source", 1}});
    writer.triangle({{"normalTexture", {{"index", 0}}}, {"occlusionTexture", {{"index", 1}}}});
    write("data.bin", writer.buffer);
    for (const std::string& text : {writer.gltf("data.bin"), writer.gltf(), writer.glb()}) {
        write("file" + std::to_string(files_) + ".gltf", text);
        const auto asset = store_.gltf("file" + std::to_string(files_++) + ".gltf");
        EXPECT_EQ(first_mesh(*asset).mesh.triangle_count(), 1u);
        EXPECT_EQ(first_material(*asset).normal_texture.texture->image.bytes()[1], 20);
        EXPECT_EQ(first_material(*asset).occlusion_texture.texture->image.bytes()[1], 50);
    }
}

TEST_F(GltfMaterial, FilesOutsideTheFolderAreRefused) {
    std::filesystem::create_directories(folder_ / "inner");
    write("outside.png", png(1, 2, 3));
    write("outside.bin", std::string(36, '\0'));
    const auto error = [&](const std::string& image, const std::string& buffer) {
        GltfWriter writer;
        writer.add("images", {{"uri", image}});
        writer.add("textures", {{"source", 0}});
        writer.triangle({{"normalTexture", {{"index", 0}}}});
        const std::string name = "inner/file" + std::to_string(files_++) + ".gltf";
        write(name, writer.gltf(buffer));
        return error_of_file(name);
    };
    EXPECT_CONTAINS(error("../outside.png", ""), "leaves its folder");
    EXPECT_CONTAINS(error("%2e%2e/outside.png", ""), "leaves its folder");
    EXPECT_CONTAINS(error((folder_ / "outside.png").string(), ""), "not a relative path");
    EXPECT_CONTAINS(error("http://example.org/a.png", ""), "not a file beside");
    EXPECT_CONTAINS(error("file:///etc/passwd", ""), "not a file beside");
    EXPECT_CONTAINS(error("missing.png", ""), "missing.png");
    EXPECT_CONTAINS(error("missing.png", "../outside.bin"), "leaves its folder");
    EXPECT_CONTAINS(error("missing.png", "http://example.org/a.bin"), "/buffers/0");
    EXPECT_CONTAINS(error("missing.png", "lost.bin"), "lost.bin");
    std::filesystem::create_symlink(folder_ / "outside.png", folder_ / "inner" / "link.png");
    EXPECT_CONTAINS(error("link.png", ""), "leaves its folder");
}

TEST_F(GltfMaterial, BrokenPicturesAreNamed) {
    GltfWriter writer;
    const int index = texture(writer, png(1, 2, 3).substr(0, 50));
    writer.triangle({{"normalTexture", {{"index", index}}}});
    EXPECT_CONTAINS(error_of(writer), "/images/0 (picture)");
    GltfWriter unused;
    (void)texture(unused, "garbage");
    unused.triangle();
    EXPECT_EQ(error_of(unused), "no error") << "what nothing shows is not decoded";
}

TEST_F(GltfMaterial, ExtensionsThatAreRequiredMustBeKnown) {
    GltfWriter writer;
    writer.triangle();
    writer.root["extensionsUsed"] = {"KHR_draco_mesh_compression", "KHR_materials_ior", "EXT_other"};
    const auto asset = load(writer);
    EXPECT_EQ(asset->warnings, (std::vector<std::string>{"extension KHR_draco_mesh_compression is ignored",
                                                         "extension EXT_other is ignored"}));
    writer.root["extensionsRequired"] = {"KHR_materials_ior"};
    EXPECT_EQ(error_of(writer), "no error");
    writer.root["extensionsRequired"] = {"KHR_draco_mesh_compression", "KHR_materials_ior", "EXT_other"};
    const std::string error = error_of(writer);
    EXPECT_CONTAINS(error, "not supported: KHR_draco_mesh_compression, EXT_other");
    EXPECT_CONTAINS(error, "KHR_texture_transform");
}

TEST_F(GltfMaterial, OtherVersionsAndBrokenTextAreErrors) {
    GltfWriter writer;
    writer.triangle();
    writer.root["asset"]["version"] = "1.0";
    EXPECT_CONTAINS(error_of(writer), "/asset/version");
    write("broken.gltf", "{\n  \"asset\": { \"version\": \"2.0\", }\n}");
    EXPECT_CONTAINS(error_of_file("broken.gltf"), "broken.gltf:2:");
    std::string deep = "{\"asset\":{\"version\":\"2.0\"},\"extras\":";
    for (int i = 0; i < 100000; ++i) deep += '[';
    write("deep.gltf", deep);
    EXPECT_CONTAINS(error_of_file("deep.gltf"), "nesting");
    write("empty.glb", "glTF");
    EXPECT_CONTAINS(error_of_file("empty.glb"), "truncated");
}

TEST_F(GltfMaterial, AChangedPictureReloadsTheWhole) {
    write("t.png", png(1, 2, 3));
    GltfWriter writer;
    writer.add("images", {{"uri", "t.png"}});
    writer.add("textures", {{"source", 0}});
    writer.triangle({{"normalTexture", {{"index", 0}}}});
    const auto before = load(writer);
    const auto reloads = [&] {
        for (int i = 0; i < 40; ++i) {
            if (store_.reload_changed()) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
        return false;
    };
    write("t.png", "broken");
    log::set_sink([](log::Level, std::string_view) {});
    EXPECT_FALSE(reloads());
    log::set_sink({});
    EXPECT_EQ(store_.gltf("file0.glb"), before) << "the last good one";
    write("t.png", png(7, 8, 9));
    EXPECT_TRUE(reloads());
    const auto after = store_.gltf("file0.glb");
    EXPECT_NE(after->id, before->id);
    EXPECT_NE(first_material(*after).id, first_material(*before).id);
    EXPECT_EQ(first_material(*after).normal_texture.texture->image.bytes()[0], 7);
}

TEST_F(GltfMaterial, CollectKeepsAFileWhosePartsAreInUse) {
    GltfWriter writer;
    writer.triangle();
    const uint64_t id = load(writer)->id;
    auto mesh = store_.gltf("file0.glb")->nodes[0].primitives[0].mesh;
    store_.collect();
    EXPECT_EQ(store_.gltf("file0.glb")->id, id);
    mesh.reset();
    store_.collect();
    EXPECT_NE(store_.gltf("file0.glb")->id, id);
}

}  // namespace
}  // namespace tyndall
