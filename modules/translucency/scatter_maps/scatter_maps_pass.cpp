#include "scatter_maps/scatter_maps_pass.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "body_size.h"
#include "core/log.h"
#include "render/draw_state.h"
#include "render/frame.h"
#include "render/light_state.h"
#include "render/seams.h"
#include "seen_surface.h"

namespace tyndall::translucency {
namespace {

constexpr const char *kPlaces = "translucent_scatter_places", *kNear = "translucent_scatter_near",
                     *kDeep = "translucent_scatter_deep";
constexpr gpu::SamplerDesc kNearest{.filter = gpu::Filter::nearest};

gpu::ProgramDesc program_of(const ScatterMapsPass::Variant& variant, const std::string& name) {
    std::vector<std::string> defines{fmt::format("STEPS {}", variant.steps)};
    constexpr const char* kForms[] = {"FORM_KI", "FORM_HERY", "FORM_GREEN"};
    defines.emplace_back(kForms[static_cast<size_t>(variant.form)]);
    if (variant.bends) defines.emplace_back("BENDS");
    if (variant.light == ScatterMapsLight::once) defines.emplace_back("ONCE");
    if (variant.falloff == ScatterMapsFalloff::ramp) defines.emplace_back("RAMP");
    return {.name = "translucency.scatter_maps." + name,
            .fragment = "translucency/scatter_maps/" + name + ".frag",
            .defines = std::move(defines)};
}

glm::vec3 axis_lengths(const glm::mat4& transform) {
    return {glm::length(transform[0]), glm::length(transform[1]), glm::length(transform[2])};
}

}  // namespace

ScatterMapsPass::ScatterMapsPass(std::shared_ptr<TechniquePlan> plan, const TranslucencySettings& settings)
    : plan_(std::move(plan)),
      settings_(settings),
      entry_programs_({.name = "translucency.scatter_maps.entry",
                       .vertex = "translucency/light_view.vert",
                       .fragment = "translucency/scatter_maps/entry.frag"}) {}

void ScatterMapsPass::declare(PassDeclaration& declaration) {
    declaration.stage(Stage::diffusion)
        .reads("scene_depth", "where the surfaces are seen")
        .reads("gbuffer_normal", "toward the eye")
        .reads("shadow_maps", "what stands between lights and solids", true)
        .reads("gbuffer_surface", "which surface is seen")
        .writes(kPlaces, {.format = gpu::Format::rg32f, .scale = 0.5f},
                "pixels of a solid at which its light is blurred")
        .writes(kNear, {.format = gpu::Format::rgba16f, .scale = 0.5f}, "blurred light that entered near by")
        .writes(kDeep, {.format = gpu::Format::rgba16f, .scale = 0.5f}, "blurred light from deep inside")
        .updates("light_diffuse", "light that leaves translucent surfaces in place of what arrives there")
        .after("translucency.tsm");
}

void ScatterMapsPass::execute(PassContext& context) {
    Frame& frame = context.frame();
    if (settings_.enabled)
        for (const size_t index : plan_->surfaces(frame.scene, Technique::scatter_maps)) {
            const Surface& surface = frame.scene.surfaces[index];
            const PixelRectangle pixels = pixels_of(surface.bounds, frame.block.view_projection, context.size());
            Object& object = objects_.of(surface);
            if (!update_body(object, surface) || pixels.empty()) continue;
            update_tables(object, surface);
            update_maps(context, surface, object);
            render(context, surface, float(index + 1), pixels, object);
        }
    objects_.end_frame();
}

void ScatterMapsPass::render(PassContext& context, const Surface& surface, float number, const PixelRectangle& pixels,
                             const Object& object) {
    const Variant variant = variant_of(surface);
    const bool blurs = variant.form == ScatterMapsForm::ki && variant.light == ScatterMapsLight::all;
    glEnable(GL_SCISSOR_TEST);
    if (blurs) blur(context, pixels, number, object);
    const std::string_view targets[] = {"light_diffuse"};
    context.bind_targets(targets, -1);
    glScissor(pixels.low.x, pixels.low.y, pixels.size.x, pixels.size.y);
    begin(context, surface, number, object);
    add_lights(context, surface, number, object);
    if (blurs) spread(context, surface, number, object);
    glDisable(GL_SCISSOR_TEST);
}

ScatterMapsPass::Variant ScatterMapsPass::variant_of(const Surface& surface) const {
    const ScatterMapsSettings& s = settings_.scatter_maps;
    const int steps = s.form == ScatterMapsForm::hery ? std::max(s.steps / 2, 1) : s.steps;
    return {s.form, s.light, s.falloff, steps, surface.interior->eta > 1.0f};
}

bool ScatterMapsPass::update_body(Object& object, const Surface& surface) const {
    const glm::vec3 shape = axis_lengths(surface.transform);
    if (object.mesh == surface.mesh->id && glm::all(glm::lessThan(glm::abs(object.shape - shape), 1e-4f * shape)))
        return object.body_radius > 0.0f;
    const bool flat = !(std::abs(glm::determinant(glm::mat3(surface.transform))) > 0.0f);
    const bool said = object.mesh == surface.mesh->id && object.body_radius == 0.0f;
    object.mesh = surface.mesh->id;
    object.shape = shape;
    object.body_radius = flat ? 0.0f : body_radius(surface.mesh->mesh, glm::mat3(surface.transform));
    if (object.body_radius == 0.0f && !said)
        log::warning("translucency: {}: the mesh {} {}: it is drawn plainly", surface.material->name,
                     surface.mesh->name, flat ? "is scaled to nothing" : "encloses nothing");
    return object.body_radius > 0.0f;
}

void ScatterMapsPass::update_tables(Object& object, const Surface& surface) const {
    const float extent = 0.5f * glm::length(object.shape * surface.mesh->mesh.bounds.size()) / std::sqrt(3.0f);
    const ScatterKey key{*surface.interior,  settings_.model, settings_.scaling,
                         object.body_radius, extent,          settings_.scatter_maps};
    object.phase.update(key.interior.phase);
    object.interior.paint(plan_->paints().of(surface, settings_.model), surface);
    if (object.version > 0 && same(key, object.key)) return;
    object.key = key;
    ++object.version;
    const ScatterTables tables = scatter_tables(key);
    object.block = gpu::Buffer(sizeof tables.block, &tables.block, "translucency.scatter_maps");
    std::vector<glm::vec4> texels = tables.kernel[0];
    texels.insert(texels.end(), tables.kernel[1].begin(), tables.kernel[1].end());
    object.kernel = gpu::Texture({.format = gpu::Format::rgba32f, .width = ScatterTables::kColumns, .height = 2},
                                 "translucency.kernel");
    object.kernel.upload(0, 0, texels.data());
    object.cosines =
        gpu::Texture({.format = gpu::Format::rgba32f, .width = ScatterBlock::kCosines, .height = ScatterTables::kRows},
                     "translucency.cosines");
    object.cosines.upload(0, 0, tables.cosines.data());
    object.interior.update({optics_of(key.interior), key.model, key.scaling, tables.first_ring, object.body_radius});
}

void ScatterMapsPass::bind_solid(const gpu::Program& program, const Object& object) {
    program.block("ScatterMaps", object.block);
    program.texture("kernel_table", object.kernel, {.filter = gpu::Filter::linear});
    program.texture("cosine_table", object.cosines, {.filter = gpu::Filter::linear});
    object.interior.bind(program);
    object.phase.bind(program);
}

void ScatterMapsPass::update_maps(PassContext& context, const Surface& surface, Object& object) {
    Frame& frame = context.frame();
    const size_t lights = frame.scene.lights.size();
    const int size = settings_.scatter_maps.map_size;
    if (object.maps.size() != lights)
        log::info("translucency: {}: {} maps of {} x {}, {:.1f} MB", surface.material->name, lights, size, size,
                  double(lights * ScatterMap::bytes(size)) / 1048576.0);
    object.maps.resize(lights);
    for (size_t i = 0; i < lights; ++i) {
        std::string state;
        append_light_state(state, frame, i, objects_.frame());
        append_state(state, surface.transform);
        append_state(state, object.version);
        append_state(state, plan_->paints().number(surface, settings_.model));
        append_state(state, size);
        object.maps[i].update(
            context, i, surface, size, std::move(state),
            [&](const gpu::Program& program) { bind_solid(program, object); }, entry_programs_);
    }
}

void ScatterMapsPass::begin(PassContext& context, const Surface& surface, float number, const Object& object) {
    Frame& frame = context.frame();
    const Variant variant = variant_of(surface);
    const gpu::Program& program = frame.shaders.program(program_of(variant, "begin"));
    program.use();
    bind_frame(program, frame);
    frame.seams.bind(Seam::indirect_light, program, context);
    bind_seen(program, context, surface, number, table_);
    bind_solid(program, object);
    program.set("ambient", variant.light == ScatterMapsLight::once ? 0.0f : 1.0f);
    const DrawState state(DepthState::off, BlendState::attenuate_add);
    gpu::draw_fullscreen();
}

void ScatterMapsPass::add_lights(PassContext& context, const Surface& surface, float number, const Object& object) {
    Frame& frame = context.frame();
    const Variant variant = variant_of(surface);
    LightPrograms& programs = programs_.try_emplace(variant, program_of(variant, "light")).first->second;
    programs.begin();
    const DrawState state(DepthState::off, BlendState::add);
    for (size_t i = 0; i < frame.scene.lights.size(); ++i) {
        const gpu::Program& program = programs.use(frame, i, [&](const gpu::Program& fresh) {
            frame.seams.bind(Seam::light_transmittance, fresh, context);
            bind_seen(fresh, context, surface, number, table_);
            bind_solid(fresh, object);
        });
        program.set("light_index", unsigned(i));
        object.maps[i].bind(program);
        gpu::draw_fullscreen();
    }
}

void ScatterMapsPass::blur(PassContext& context, const PixelRectangle& pixels, float number, const Object& object) {
    static const gpu::ProgramDesc kFind{.name = "translucency.scatter_maps.places",
                                        .fragment = "translucency/scatter_maps/places.frag"};
    static const gpu::ProgramDesc kBlur{.name = "translucency.scatter_maps.blur",
                                        .fragment = "translucency/scatter_maps/blur.frag"};
    Frame& frame = context.frame();
    const glm::ivec2 low = pixels.low / 2, high = (pixels.low + pixels.size + 1) / 2;
    glScissor(low.x, low.y, high.x - low.x, high.y - low.y);
    const std::string_view places[] = {kPlaces};
    context.bind_targets(places, -1);
    const gpu::Program& find = frame.shaders.program(kFind);
    find.use();
    find.texture("scene_depth", context.texture("scene_depth"), kNearest);
    find.texture("gbuffer_surface", context.texture("gbuffer_surface"), kNearest);
    find.set("number", number);
    gpu::draw_fullscreen();
    const std::string_view targets[] = {kNear, kDeep};
    context.bind_targets(targets, -1);
    const gpu::Program& program = frame.shaders.program(kBlur);
    program.use();
    bind_frame(program, frame);
    bind_solid(program, object);
    program.texture("blur_places", context.texture(kPlaces), kNearest);
    glBlendFunc(GL_ONE, GL_ONE);
    for (size_t i = 0; i < object.maps.size(); ++i) {  // the first takes the place of what was there
        (i > 0 ? glEnable : glDisable)(GL_BLEND);
        object.maps[i].bind(program);
        gpu::draw_fullscreen();
    }
    glDisable(GL_BLEND);
}

void ScatterMapsPass::spread(PassContext& context, const Surface& surface, float number, const Object& object) {
    if (object.maps.empty()) return;
    static const gpu::ProgramDesc kEven{.name = "translucency.scatter_maps.spread",
                                        .fragment = "translucency/scatter_maps/spread.frag"};
    static const gpu::ProgramDesc kBends{.name = "translucency.scatter_maps.spread",
                                         .fragment = "translucency/scatter_maps/spread.frag",
                                         .defines = {"BENDS"}};
    Frame& frame = context.frame();
    const gpu::Program& program = frame.shaders.program(variant_of(surface).bends ? kBends : kEven);
    program.use();
    bind_frame(program, frame);
    bind_seen(program, context, surface, number, table_);
    bind_solid(program, object);
    program.texture("blur_places", context.texture(kPlaces), kNearest);
    program.texture("blurred_near", context.texture(kNear), kNearest);
    program.texture("blurred_deep", context.texture(kDeep), kNearest);
    const DrawState state(DepthState::off, BlendState::add);
    gpu::draw_fullscreen();
}

}  // namespace tyndall::translucency
