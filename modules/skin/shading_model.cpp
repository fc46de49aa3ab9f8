#include "shading_model.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "physics/physics.h"
#include "physics/tables.h"
#include "render/frame.h"

namespace tyndall::skin {
namespace {

constexpr size_t kRows = 3;  // a surface's texels: shaders/surfaces.glsl

/// Share of the normal map that light of each channel does not see, since it spreads over the detail: what the profile
/// leaves of a wave (its Fourier transform), from 1.
glm::vec3 flattened(const SurfaceDiffusion& diffusion) {
    const float wave = 2.0f * physics::kPi / diffusion.detail_m;
    glm::vec3 kept(0.0f);
    for (const physics::DiffusionLobe& lobe : diffusion.profile.lobes)
        kept += lobe.weight * std::exp(-0.5f * lobe.variance_m2 * wave * wave);
    return glm::clamp(1.0f - kept, 0.0f, 1.0f);
}

bool flattens(Technique technique) {
    return technique == Technique::blurred_normals || technique == Technique::preintegrated;
}

Response response_of(Technique technique, const physics::DiffusionProfile& profile) {
    if (technique == Technique::wrap) return wrap_response(profile);
    if (technique == Technique::preintegrated) return preintegrated_response(profile);
    return lambert_response();
}

gpu::Texture table(const std::vector<glm::vec4>& texels, int width, int height, const char* name) {
    gpu::Texture texture({.format = gpu::Format::rgba32f, .width = width, .height = height}, name);
    texture.upload(0, 0, texels.data());
    return texture;
}

}  // namespace

void SkinTables::update(const RenderScene& scene) {
    const size_t width = scene.surfaces.size() + 1;
    std::vector<Layer> layers{{Technique::lambert, {}}};
    rows_.assign(kRows * width, glm::vec4(0.0f));
    profiles_.clear();
    for (size_t i = 0; i < scene.surfaces.size(); ++i) {
        const Surface& surface = scene.surfaces[i];
        if (!surface.diffusion) continue;
        const Technique technique = technique_of(*surface.diffusion);
        rows_[i + 1] = surface.material->shading_parameters;
        rows_[width + i + 1] = glm::vec4(flattens(technique) ? flattened(*surface.diffusion) : glm::vec3(0.0f),
                                         float(layer_of(*surface.diffusion, layers)));
        rows_[2 * width + i + 1] = glm::vec4(surface.diffusion->pre_scatter, float(profile_of(*surface.diffusion)),
                                             float(technique), surface.diffusion->transmission);
    }
    if (layers != layers_ || responses_.name() == 0) upload_layers(layers);
    if (rows_ != uploaded_rows_ || surfaces_.name() == 0) {
        surfaces_ = table(rows_, int(width), int(kRows), "skin surfaces");
        uploaded_rows_ = rows_;
    }
}

size_t SkinTables::layer_of(const SurfaceDiffusion& diffusion, std::vector<Layer>& layers) const {
    const Technique technique = technique_of(diffusion);
    if (technique != Technique::wrap && technique != Technique::preintegrated) return 0;
    const Layer wanted{technique, diffusion.profile};
    const auto found = std::ranges::find(layers, wanted);
    if (found != layers.end()) return size_t(found - layers.begin());
    layers.push_back(wanted);
    return layers.size() - 1;
}

size_t SkinTables::profile_of(const SurfaceDiffusion& diffusion) {
    const auto same = [&](const physics::DiffusionProfile* other) { return *other == diffusion.profile; };
    const auto found = std::ranges::find_if(profiles_, same);
    if (found == profiles_.end()) {
        profiles_.push_back(&diffusion.profile);
        return profiles_.size();
    }
    return size_t(found - profiles_.begin()) + 1;
}

void SkinTables::upload_layers(const std::vector<Layer>& layers) {
    const auto array = [&](int width, int height, const char* name) {
        return gpu::Texture({.shape = gpu::Shape::array,
                             .format = gpu::Format::rgba32f,
                             .width = width,
                             .height = height,
                             .layers = int(layers.size())},
                            name);
    };
    responses_ = array(Response::kCosines, Response::kCurvatures, "skin responses");
    shadows_ = array(ShadowResponse::kShares, ShadowResponse::kWidths, "skin shadows");
    for (size_t i = 0; i < layers.size(); ++i) {
        const Layer& layer = layers[i];
        responses_.upload(0, int(i), response_of(layer.technique, layer.profile).texels.data());
        const bool scatters = layer.technique == Technique::preintegrated;
        // a profile without width leaves shadows as they are
        const physics::DiffusionProfile& profile = layer.profile;
        ShadowResponse plain;
        if (!scatters)
            for (size_t t = 0; t < plain.texels.size(); ++t)
                plain.texels[t] = glm::vec4(float(t % ShadowResponse::kShares) / (ShadowResponse::kShares - 1));
        shadows_.upload(0, int(i), (scatters ? shadow_response(profile) : plain).texels.data());
    }
    layers_ = layers;
}

/// Of a Lambertian base under the layer: what enters at an angle over what enters of even light, so that bouncing in
/// and out loses nothing (Ashikhmin & Shirley 2000 have the same idea). By cosine and roughness, as the specular table.
void SkinTables::upload_entering() {
    constexpr int kSize = physics::SpecularTable::kSize;
    const physics::SpecularTable albedo = physics::make_specular_table();
    const float f0 = physics::f0_from_eta(1.4f);
    std::vector<float> texels(size_t(kSize) * kSize);
    for (int y = 0; y < kSize; ++y) {
        const auto entering = [&](float cosine) {
            const glm::vec2 pair = albedo.sample(cosine, float(y) / float(kSize - 1));
            return 1.0f - (f0 * pair.x + pair.y);
        };
        constexpr int kSteps = 128;
        float mean = 0.0f;
        for (int i = 0; i < kSteps; ++i) {
            const float cosine = (float(i) + 0.5f) / kSteps;
            mean += 2.0f * cosine * entering(cosine) / kSteps;
        }
        for (int x = 0; x < kSize; ++x) {
            const float root = float(x) / float(kSize - 1);
            texels[size_t(y) * kSize + size_t(x)] = entering(root * root) / mean;
        }
    }
    entering_ = gpu::Texture({.format = gpu::Format::r32f, .width = kSize, .height = kSize}, "skin entering");
    entering_.upload(0, 0, texels.data());
}

void SkinTables::bind_surfaces(const gpu::Program& program, const RenderScene& scene) {
    update(scene);
    program.texture("skin_surfaces", surfaces_, {.filter = gpu::Filter::nearest});
}

void SkinTables::bind(const gpu::Program& program, const RenderScene& scene) {
    bind_surfaces(program, scene);
    if (entering_.name() == 0) upload_entering();
    program.texture("skin_responses", responses_, {.filter = gpu::Filter::linear});
    program.texture("skin_shadows", shadows_, {.filter = gpu::Filter::linear});
    program.texture("skin_entering", entering_, {.filter = gpu::Filter::linear});
}

SeamProvider shading_model(std::shared_ptr<SkinTables> tables) {
    return {.name = "skin",
            .include = "skin/shading_model.glsl",
            .function = "skin_shading_model",
            .reads = {"gbuffer_surface"},
            .bind = [tables = std::move(tables)](const gpu::Program& program, PassContext& context) {
                tables->bind(program, context.frame().scene);
                program.texture("skin_gbuffer_surface", context.texture("gbuffer_surface"),
                                {.filter = gpu::Filter::nearest});
            }};
}

}  // namespace tyndall::skin
