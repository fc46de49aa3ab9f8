#include "scene/gltf_materials.h"

#include <cmath>

#include "color/color.h"
#include "scene/gltf_values.h"

namespace tyndall {
namespace {

constexpr double kInfinity = GltfValues::kInfinity;

/// KHR_texture_transform: scaled, turned, moved. Its rotation is counter-clockwise as seen on the picture, whose V
/// points down.
glm::mat3 uv_transform(GltfValues& values, const tinygltf::Value& object) {
    const auto pair = [&](const char* name, const glm::vec2& fallback) {
        const std::vector<double> v = numbers(member(object, name));
        if (v.size() != 2) return fallback;
        return glm::vec2(values.in_range(name, v[0], -kInfinity, kInfinity),
                         values.in_range(name, v[1], -kInfinity, kInfinity));
    };
    const glm::vec2 offset = pair("offset", {0.0f, 0.0f});
    const glm::vec2 scale = pair("scale", {1.0f, 1.0f});
    const float rotation = values.number(object, "rotation", 0.0, -kInfinity, kInfinity);
    const float c = std::cos(rotation);
    const float s = std::sin(rotation);
    return {glm::vec3(c, -s, 0.0f) * scale.x, glm::vec3(s, c, 0.0f) * scale.y, glm::vec3(offset, 1.0f)};
}

/// What all forms of textureInfo have.
struct Reference {
    int index = -1;
    int uv_set = 0;
    const tinygltf::Value* transform = nullptr;
};

template <class Info>
Reference reference_to(const Info& info) {
    return {info.index, info.texCoord, extension(info.extensions, "KHR_texture_transform")};
}

/// A textureInfo inside an extension.
Reference reference_to(const tinygltf::Value& object, const char* name) {
    const tinygltf::Value* info = member(object, name);
    if (!info) return {};
    const tinygltf::Value* extensions = member(*info, "extensions");
    const auto whole = [&](const char* key, int fallback) {
        const double number = number_or(member(*info, key), fallback);
        return number >= -1.0 && number <= 1e9 ? static_cast<int>(number) : fallback;
    };
    return {whole("index", -1), whole("texCoord", 0),
            extensions ? member(*extensions, "KHR_texture_transform") : nullptr};
}

/// One material on its way from the file to the engine.
struct Maker {
    GltfFile& file;
    GltfTextures& textures;
    const glm::mat3& to_working;
    GltfValues values;
    Material& material;

    [[nodiscard]] TextureSlot slot(const Reference& from, const char* name, TextureUse use) {
        if (from.index < 0) return {};
        const std::string here = values.pointer() + "/" + name;
        TextureSlot slot{.texture = textures.get(from.index, use, here), .uv_set = from.uv_set};
        if (from.transform) {
            GltfValues transform(file, here + "/extensions/KHR_texture_transform");
            slot.uv_transform = uv_transform(transform, *from.transform);
            slot.uv_set = static_cast<int>(transform.number(*from.transform, "texCoord", slot.uv_set, 0, 1e6));
        }
        if (slot.uv_set == 0 || slot.uv_set == 1) return slot;
        file.warn("textures on UV sets beyond the second are ignored");
        return {};
    }

    void read_base(const tinygltf::Material& from) {
        const tinygltf::PbrMetallicRoughness& pbr = from.pbrMetallicRoughness;
        if (pbr.baseColorFactor.size() == 4) {
            const std::vector<double> rgb(pbr.baseColorFactor.begin(), pbr.baseColorFactor.begin() + 3);
            material.base_colour = glm::vec4(to_working * values.vector("baseColorFactor", rgb, glm::vec3(1.0f), 0, 1),
                                             values.in_range("baseColorFactor", pbr.baseColorFactor[3], 0, 1));
        }
        material.metallic = values.in_range("metallicFactor", pbr.metallicFactor, 0, 1);
        material.roughness = values.in_range("roughnessFactor", pbr.roughnessFactor, 0, 1);
        material.base_colour_texture =
            slot(reference_to(pbr.baseColorTexture), "pbrMetallicRoughness/baseColorTexture", TextureUse::colour);
        material.metallic_roughness_texture = slot(reference_to(pbr.metallicRoughnessTexture),
                                                   "pbrMetallicRoughness/metallicRoughnessTexture", TextureUse::data);
    }

    void read_surface(const tinygltf::Material& from) {
        material.normal_scale = values.in_range("normalTexture/scale", from.normalTexture.scale, -kInfinity, kInfinity);
        material.normal_texture = slot(reference_to(from.normalTexture), "normalTexture", TextureUse::data);
        material.occlusion_strength =
            values.in_range("occlusionTexture/strength", from.occlusionTexture.strength, 0, 1);
        material.occlusion_texture = slot(reference_to(from.occlusionTexture), "occlusionTexture", TextureUse::data);
        float strength = 1.0f;
        if (const auto* object = extension(from.extensions, "KHR_materials_emissive_strength"))
            strength = values.number(*object, "emissiveStrength", 1.0, 0, kInfinity);
        material.emissive =
            to_working * values.vector("emissiveFactor", from.emissiveFactor, glm::vec3(0.0f), 0, 1) * strength;
        material.emissive_texture = slot(reference_to(from.emissiveTexture), "emissiveTexture", TextureUse::colour);
        material.double_sided = from.doubleSided;
        material.alpha_cutoff = values.in_range("alphaCutoff", from.alphaCutoff, 0, kInfinity);
        if (from.alphaMode == "MASK")
            material.alpha_mode = AlphaMode::mask;
        else if (from.alphaMode == "BLEND")
            material.alpha_mode = AlphaMode::blend;
        else if (from.alphaMode != "OPAQUE")
            file.fail(values.pointer() + "/alphaMode", "unknown mode '" + from.alphaMode + "'",
                      "'OPAQUE', 'MASK' or 'BLEND'");
    }

    void read_interface(const tinygltf::ExtensionMap& from) {
        if (const auto* ior = extension(from, "KHR_materials_ior"))
            material.ior = values.number(*ior, "ior", 1.5, 1, 100);
        if (const auto* specular = extension(from, "KHR_materials_specular")) {
            material.specular = values.number(*specular, "specularFactor", 1, 0, 1);
            material.specular_colour =
                to_working * values.vector(*specular, "specularColorFactor", glm::vec3(1.0f), 0, kInfinity);
            material.specular_texture =
                slot(reference_to(*specular, "specularTexture"), "specularTexture", TextureUse::data);
            material.specular_colour_texture =
                slot(reference_to(*specular, "specularColorTexture"), "specularColorTexture", TextureUse::colour);
        }
    }

    void read_interior(const tinygltf::ExtensionMap& from) {
        if (const auto* transmission = extension(from, "KHR_materials_transmission")) {
            material.transmission = values.number(*transmission, "transmissionFactor", 0, 0, 1);
            material.transmission_texture =
                slot(reference_to(*transmission, "transmissionTexture"), "transmissionTexture", TextureUse::data);
        }
        if (const auto* diffuse = extension(from, "KHR_materials_diffuse_transmission")) {
            material.diffuse_transmission = values.number(*diffuse, "diffuseTransmissionFactor", 0, 0, 1);
            material.diffuse_transmission_colour =
                to_working * values.vector(*diffuse, "diffuseTransmissionColorFactor", glm::vec3(1.0f), 0, 1);
            material.diffuse_transmission_texture = slot(reference_to(*diffuse, "diffuseTransmissionTexture"),
                                                         "diffuseTransmissionTexture", TextureUse::data);
            material.diffuse_transmission_colour_texture =
                slot(reference_to(*diffuse, "diffuseTransmissionColorTexture"), "diffuseTransmissionColorTexture",
                     TextureUse::colour);
        }
        if (const auto* volume = extension(from, "KHR_materials_volume")) {
            material.thickness_m = values.number(*volume, "thicknessFactor", 0, 0, kInfinity);
            material.thickness_texture =
                slot(reference_to(*volume, "thicknessTexture"), "thicknessTexture", TextureUse::data);
            material.attenuation_colour =
                to_working * values.vector(*volume, "attenuationColor", glm::vec3(1.0f), 0, 1);
            material.attenuation_distance_m = values.number(*volume, "attenuationDistance", 0, 0, kInfinity);
        }
    }
};

}  // namespace

glm::mat3 rec709_to_working(const ColorConfig& config) {
    // The sRGB curve leaves 0 and 1 as they are, so that the primaries of encoded colours are those of linear ones.
    std::vector<float> rgb{1, 0, 0, 0, 1, 0, 0, 0, 1};
    config.convert(rgb, config.srgb_texture_space(), config.working_space());
    return {rgb[0], rgb[1], rgb[2], rgb[3], rgb[4], rgb[5], rgb[6], rgb[7], rgb[8]};
}

std::shared_ptr<const Material> GltfMaterials::get(int index, std::string_view pointer) {
    const tinygltf::Material plain;
    const tinygltf::Material& from = index == -1 ? plain : file_.at(file_.model.materials, index, "material", pointer);
    std::shared_ptr<const Material>& made = made_[index];
    if (made) return made;
    const std::string here = "/materials/" + std::to_string(index);
    auto material = std::make_shared<Material>();
    material->id = new_asset_id();
    material->name = name_ + ": " + (from.name.empty() ? here : from.name);
    Maker maker{file_, textures_, to_working_, GltfValues(file_, here), *material};
    maker.read_base(from);
    maker.read_surface(from);
    maker.read_interface(from.extensions);
    maker.read_interior(from.extensions);
    return made = std::move(material);
}

}  // namespace tyndall
