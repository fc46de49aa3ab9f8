#include "radiance_maps/radiance_maps_pass.h"

#include <epoxy/gl.h>

#include <chrono>
#include <cmath>
#include <glm/matrix.hpp>

#include "body_space.h"
#include "core/log.h"
#include "physics/blue_noise.h"
#include "radiance_maps/balance.h"
#include "radiance_maps/dispatch.h"
#include "render/frame.h"
#include "render/pixel_rectangle.h"
#include "render/seams.h"
#include "seen_surface.h"

namespace tyndall::translucency {
namespace {

/// Of the light maps' texels that may change without a restart.
constexpr float kChangedShare = 1e-3f;
/// The widest Gaussian of a kernel reaches over an object that many pieces wide.
constexpr float kPiecesAcross = 200.0f;
/// Texels of the next finer level within which places are of one surface, as in view_maps.cpp.
constexpr float kSameSurface = 4.0f;
constexpr int kGroup = 64, kRowOfGroups = 1024;

/// The byte offset of a field of the block State.
enum class StateGroups { gather = 16, filter = 32, next_filter = 48 };

void dispatch(const gpu::Buffer& state, StateGroups groups) {
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, state.name());
    glDispatchComputeIndirect(static_cast<GLintptr>(groups));
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, 0);
    wait_for_shaders();
}

/// In steps of a tenth of a per mille, so that what turns stays as it is.
float steady(float length) {
    return std::exp(std::round(1e4f * std::log(std::max(length, 1e-20f))) * 1e-4f);
}

gpu::Texture make_blue_noise() {
    gpu::Texture texture(
        {.format = gpu::Format::r32f, .width = physics::kBlueNoiseSize, .height = physics::kBlueNoiseSize},
        "translucency.maps.blue_noise");
    texture.upload(0, 0, physics::blue_noise_mask().data());
    return texture;
}

}  // namespace

RadianceMapsPass::RadianceMapsPass(std::shared_ptr<TechniquePlan> plan, const TranslucencySettings& settings)
    : plan_(std::move(plan)),
      settings_(settings),
      enter_programs_(
          {.name = "translucency.radiance_maps.enter", .compute = "translucency/radiance_maps/enter.comp"}) {}

void RadianceMapsPass::declare(PassDeclaration& declaration) {
    declaration.stage(Stage::diffusion)
        .reads("scene_depth", "where the surfaces are seen")
        .reads("gbuffer_normal", "toward the eye")
        .reads("gbuffer_surface", "which surface is seen")
        .writes(kAround, {.format = gpu::Format::rgba32f},
                "irradiance from all around where light that leaves there has entered; alpha 1 where it is known")
        .updates("light_diffuse", "light that leaves translucent surfaces in place of what arrives there")
        .after("translucency.htsm");
}

void RadianceMapsPass::execute(PassContext& context) {
    const RenderScene& scene = context.frame().scene;
    const auto surfaces = plan_->surfaces(scene, Technique::radiance_maps);
    if (settings_.enabled && !surfaces.empty()) {
        if (has_indirect_light(context.frame())) forget_around(context);
        for (const size_t index : surfaces) render(context, scene.surfaces[index], float(index + 1));
    }
    objects_.end_frame();
    bodies_.end_frame();
}

void RadianceMapsPass::render(PassContext& context, const Surface& surface, float number) {
    const float volume = std::abs(glm::determinant(glm::mat3(surface.transform)));
    if (!(volume > 0.0f) || !std::isfinite(volume)) return;
    if (pixels_of(surface.bounds, context.frame().block.view_projection, context.size()).empty()) return;
    const Body& body = body_of(context, surface);
    if (body.maps->texel_count() == 0) return;
    Object& object = object_of(surface, *body.maps);
    const glm::mat4 world = world_from_stretched(surface, body.shape);
    const Seen seen{surface, *body.maps, object, world, steady(metres_of_unit(world)), number};
    prepare(context, seen);
    if (!object.lights.layers().empty()) {
        enter(context, seen);
        gather(context, seen);
        filter(context, seen);
    }
    object.restart = false;
    if (has_indirect_light(context.frame())) light_around(context, seen);
    combine(context, seen);
}

RadianceMapsPass::Body& RadianceMapsPass::body_of(PassContext& context, const Surface& surface) {
    const glm::vec3 shape = shape_of(surface.transform);
    Body& body = bodies_.at(shape_key(surface));
    const RadianceMapsSettings& wanted = settings_.radiance_maps;
    if (!body.maps || body.maps->views() != wanted.views || body.maps->resolution() != wanted.resolution) {
        const auto begun = std::chrono::steady_clock::now();
        body.shape = shape;
        body.maps = std::make_unique<ViewMaps>(context.frame().shaders, stretched(surface.mesh->mesh, shape),
                                               wanted.views, wanted.resolution);
        log::info("translucency: {}: {} views of {} x {}, {} texels see it, {:.1f} MB, {:.2f} s", surface.mesh->name,
                  wanted.views, wanted.resolution, wanted.resolution, body.maps->texel_count(),
                  double(body.maps->bytes()) / 1048576.0,
                  std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count());
    }
    return body;
}

RadianceMapsPass::Object& RadianceMapsPass::object_of(const Surface& surface, const ViewMaps& body) {
    Object& object = objects_.of(surface);
    if (object.body == &body && object.leaving.name() != 0 && object.leaving.desc().width == body.resolution() &&
        object.leaving.desc().layers == body.views())
        return object;
    object = Object{};
    object.body = &body;
    object.leaving = gpu::Texture({.shape = gpu::Shape::array,
                                   .format = gpu::Format::rgba32f,
                                   .width = body.resolution(),
                                   .height = body.resolution(),
                                   .layers = body.views(),
                                   .mips = ViewMaps::kLevels},
                                  "translucency.maps.leaving");
    object.scales = gpu::Texture({.shape = gpu::Shape::array,
                                  .format = gpu::Format::rgba16f,
                                  .width = body.resolution(),
                                  .height = body.resolution(),
                                  .layers = body.views()},
                                 "translucency.maps.scales");
    for (int level = 0; level < ViewMaps::kLevels; ++level) object.leaving.clear(level, glm::vec4(0.0f));
    const std::array<uint32_t, 16> nothing{};
    object.state = gpu::Buffer(std::span<const uint32_t>(nothing), "translucency.maps.state");
    return object;
}

/// Interior, scales and light maps, where something has changed.
void RadianceMapsPass::prepare(PassContext& context, const Seen& seen) {
    Object& object = seen.object;
    const float piece = 2.0f * seen.body.radius * seen.metres_of_unit / kPiecesAcross;
    object.key = {optics_of(*seen.surface.interior), settings_.model, settings_.scaling, piece,
                  seen.body.sphere_radius * seen.metres_of_unit};
    const bool changed = object.interior.update(object.key);
    object.interior.paint(plan_->paints().of(seen.surface, settings_.model), seen.surface);
    if (changed) {
        const Mesh& mesh = seen.body.drawn();
        const std::vector<Balanced> vertices =
            balance(mesh, object.key.optics, settings_.model, settings_.scaling, seen.metres_of_unit);
        object.balanced = gpu::Buffer(std::span<const Balanced>(vertices), "translucency.maps.balanced");
        seen.body.draw_scales(context.frame().shaders, object.balanced, object.scales);
    }
    const RadianceMapsSettings& settings = settings_.radiance_maps;
    const bool moved =
        object.lights.fit(context.frame().scene, seen.world_from_body, seen.body, settings.light_resolution);
    if (changed || moved) object.lights.draw(context.frame().shaders, seen.body, object.balanced);
    object.restart = object.restart || changed || moved || object.samples != settings.samples;
    object.samples = settings.samples;
    if (object.lights.left_out() > 0 && !object.said_left_out) {
        log::warning("translucency: {}: {} lights have no room in its {} light maps", seen.surface.material->name,
                     object.lights.left_out(), LightMaps::kMaxLayers);
        object.said_left_out = true;
    }
}

/// Fills the light maps' entries, light by light.
void RadianceMapsPass::enter(PassContext& context, const Seen& seen) {
    Frame& frame = context.frame();
    const LightMaps& lights = seen.object.lights;
    const bool mirrored = glm::determinant(glm::mat3(seen.world_from_body)) < 0.0f;
    const glm::mat3 areas = area_matrix(seen.world_from_body);
    const auto groups = GLuint(groups_of(lights.resolution()));
    enter_programs_.begin();
    for (size_t first = 0; first < lights.layers().size();) {
        const size_t light = lights.layers()[first].light;
        size_t last = first;
        while (last < lights.layers().size() && lights.layers()[last].light == light) ++last;
        const gpu::Program& program = enter_programs_.use(frame, light, [&](const gpu::Program& fresh) {
            frame.seams.bind(Seam::light_transmittance, fresh, context);
            lights.bind(fresh);
            seen.object.interior.bind(fresh);
            fresh.block("State", seen.object.state);
            fresh.set("metres_of_unit", seen.metres_of_unit);
            fresh.set("world_from_body", seen.world_from_body);
            fresh.set("normals_to_world", mirrored ? -areas : areas);
            fresh.set("body_from_world", glm::mat3(glm::inverse(seen.world_from_body)));
        });
        program.set("light_index", unsigned(light));
        program.set("first_layer", int(first));
        glDispatchCompute(groups, groups, GLuint(last - first));
        first = last;
    }
    wait_for_shaders();
}

void RadianceMapsPass::gather(PassContext& context, const Seen& seen) {
    if (blue_noise_.name() == 0) blue_noise_ = make_blue_noise();
    const RadianceMapsSettings& settings = settings_.radiance_maps;
    const LightMaps& lights = seen.object.lights;
    const int groups = (int(seen.body.texel_count()) + kGroup - 1) / kGroup;
    const int size = seen.body.resolution();
    const gpu::Program& advance = use_compute(context, "advance");
    advance.block("State", seen.object.state);
    advance.set("restart", seen.object.restart ? 1 : 0);
    advance.set("most_changed",
                int(kChangedShare * float(lights.resolution() * lights.resolution()) * float(lights.layers().size())));
    advance.set("frames", settings.frames);
    advance.set("gather_size", glm::ivec2(std::min(groups, kRowOfGroups), (groups + kRowOfGroups - 1) / kRowOfGroups));
    advance.set("filter_size", glm::ivec3(groups_of(size / 2), groups_of(size / 2), seen.body.views()));
    advance.set("next_filter_size", glm::ivec3(groups_of(size / 4), groups_of(size / 4), seen.body.views()));
    glDispatchCompute(1, 1, 1);
    wait_for_shaders();
    const bool directional = settings_.model == Model::directional;
    const gpu::Program& program = use_compute(
        context, "gather", directional ? std::vector<std::string>{"DIRECTIONAL"} : std::vector<std::string>{});
    lights.bind(program);
    seen.object.interior.bind(program);
    program.block("State", seen.object.state);
    for (const auto& [name, texture] : {std::pair<const char*, const gpu::Texture*>{"places", &seen.body.places()},
                                        {"scales", &seen.object.scales},
                                        {"texels", &seen.body.texels()},
                                        {"blue_noise", &blue_noise_}})
        program.texture(name, *texture, {.filter = gpu::Filter::nearest});
    program.image("leaving", seen.object.leaving, 0, true);
    program.set("texel_count", int(seen.body.texel_count()));
    program.set("samples", settings.samples);
    program.set("metres_of_unit", seen.metres_of_unit);
    program.set("piece_radius", seen.object.key.piece_radius);
    dispatch(seen.object.state, StateGroups::gather);
}

void RadianceMapsPass::filter(PassContext& context, const Seen& seen) const {
    const gpu::Program& program = use_compute(context, "filter");
    const float texel = 2.0f * seen.body.radius / float(seen.body.resolution());
    for (int level = 1; level < ViewMaps::kLevels; ++level) {
        program.texture("places", seen.body.places(), {.filter = gpu::Filter::nearest});
        program.image("fine", seen.object.leaving, level - 1, false);
        program.image("coarse", seen.object.leaving, level, true);
        program.set("level", level);
        program.set("same_unit", kSameSurface * std::ldexp(texel, level - 1));
        dispatch(seen.object.state, level == 1 ? StateGroups::filter : StateGroups::next_filter);
    }
}

}  // namespace tyndall::translucency
