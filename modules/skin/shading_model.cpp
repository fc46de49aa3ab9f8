#include "shading_model.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "oily_layer.h"
#include "physics/physics.h"
#include "render/frame.h"
#include "texture_space/surface_finish.h"

namespace tyndall::skin {
namespace {

constexpr size_t kRows = 5;  // a surface's texels: shaders/surfaces.glsl

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

/// What a technique knows of the profile in the light pass: those that spread light later take it as it enters.
Technique light_pass(Technique technique) {
    if (technique == Technique::blurred_normals) return Technique::lambert;
    return std::min(technique, Technique::two_gaussians);
}

bool is_corrected(Technique technique) {
    return technique >= Technique::preintegrated;
}

gpu::Texture table(const std::vector<glm::vec4>& texels, int width, int height, const char* name) {
    gpu::Texture texture({.format = gpu::Format::rgba32f, .width = width, .height = height}, name);
    texture.upload(0, 0, texels.data());
    return texture;
}

}  // namespace

void SkinTables::update(const RenderScene& scene) {
    const size_t width = scene.surfaces.size() + 1;
    std::vector<Layer> layers{{Technique::lambert, {}, {}}};
    std::vector<glm::vec4> parameters{glm::vec4(1.0f, 1.0f, 0.0f, 0.0f)};
    rows_.assign(kRows * width, glm::vec4(0.0f));
    profiles_.clear();
    for (size_t i = 0; i < scene.surfaces.size(); ++i) {
        const Surface& surface = scene.surfaces[i];
        if (!surface.diffusion) continue;
        const Technique technique = technique_of(*surface.diffusion);
        rows_[i + 1] = surface.material->shading_parameters;
        rows_[width + i + 1] = glm::vec4(flattens(technique) ? flattened(*surface.diffusion) : glm::vec3(0.0f),
                                         float(layer_of(*surface.diffusion, layers)));
        rows_[2 * width + i + 1] =
            glm::vec4(usable_pre_scatter(*surface.material, surface.diffusion->pre_scatter),
                      float(profile_of(*surface.diffusion)), float(technique), surface.diffusion->transmission);
        auto mirror = std::ranges::find(parameters, surface.material->shading_parameters);
        if (mirror == parameters.end())
            mirror = parameters.insert(parameters.end(), surface.material->shading_parameters);
        rows_[3 * width + i + 1] = {surface.material->ior > 1.0f ? surface.material->specular : 0.0f,
                                    float(mirror - parameters.begin()), thickness_use(*surface.diffusion), 0.0f};
        if (is_corrected(technique)) rows_[4 * width + i + 1] = glm::vec4(surface.diffusion->corrections.limb, 0.0f);
    }
    if (parameters != parameters_ || mirrors_.name() == 0) upload_layer_tables(parameters);
    if (layers != layers_ || responses_.name() == 0) upload_layers(layers);
    if (rows_ != uploaded_rows_ || surfaces_.name() == 0) {
        surfaces_ = table(rows_, int(width), int(kRows), "skin surfaces");
        uploaded_rows_ = rows_;
    }
}

glm::vec3 SkinTables::layers(size_t index) const {
    const size_t width = rows_.size() / kRows;
    const glm::vec4 mirror = rows_[3 * width + index + 1];
    return {rows_[width + index + 1].w, mirror.x, mirror.y};
}

size_t SkinTables::layer_of(const SurfaceDiffusion& diffusion, std::vector<Layer>& layers) const {
    const Technique technique = light_pass(technique_of(diffusion));
    if (technique == Technique::lambert) return 0;
    // where light spreads later the profile is not this table's matter
    Layer wanted{technique, {}, diffusion.corrections};
    if (technique == Technique::wrap) wanted = {technique, diffusion.profile, {}};
    if (technique == Technique::preintegrated) wanted.profile = diffusion.profile;
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

Response SkinTables::response_of(const Layer& layer) {
    if (layer.technique == Technique::lambert) return lambert_response();
    if (layer.technique == Technique::wrap) return wrap_response(layer.profile);
    const bool spreads = layer.technique == Technique::preintegrated;
    return corrected(spreads ? preintegrated_response(layer.profile) : lambert_response(), layer.corrections);
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
        responses_.upload(0, int(i), response_of(layer).texels.data());
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

void SkinTables::upload_layer_tables(const std::vector<glm::vec4>& parameters) {
    mirrors_ = gpu::Texture({.shape = gpu::Shape::array,
                             .format = gpu::Format::rg32f,
                             .width = OilyLayer::kSize,
                             .height = OilyLayer::kSize,
                             .layers = int(parameters.size())},
                            "skin mirrors");
    for (size_t i = 0; i < parameters.size(); ++i) mirrors_.upload(0, int(i), oily_layer(parameters[i]).texels.data());
    parameters_ = parameters;
}

void SkinTables::bind_surfaces(const gpu::Program& program, const RenderScene& scene) {
    update(scene);
    program.texture("skin_surfaces", surfaces_, {.filter = gpu::Filter::nearest});
}

void SkinTables::bind(const gpu::Program& program, const RenderScene& scene) {
    bind_surfaces(program, scene);
    program.texture("skin_responses", responses_, {.filter = gpu::Filter::linear});
    program.texture("skin_shadows", shadows_, {.filter = gpu::Filter::linear});
    program.texture("skin_mirrors", mirrors_, {.filter = gpu::Filter::linear});
}

namespace {

/// Where skin may be seen.
ShadingModelUse seen_skin(PassContext& context) {
    const Frame& frame = context.frame();
    PixelRectangle pixels;
    for (const Surface& surface : frame.scene.surfaces)
        if (surface.diffusion)
            pixels = united(pixels, pixels_of(surface.bounds, frame.block.view_projection, context.size()));
    return {{}, pixels};
}

}  // namespace

SeamProvider shading_model(std::shared_ptr<SkinTables> tables) {
    return {.name = "skin",
            .include = "skin/shading_model.glsl",
            .function = "skin_shading_model",
            .reads = {"gbuffer_surface"},
            .bind =
                [tables = std::move(tables)](const gpu::Program& program, PassContext& context) {
                    tables->bind(program, context.frame().scene);
                    program.texture("skin_gbuffer_surface", context.texture("gbuffer_surface"),
                                    {.filter = gpu::Filter::nearest});
                },
            .use = seen_skin};
}

}  // namespace tyndall::skin
