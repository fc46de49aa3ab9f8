#include "htsm/htsm_pass.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "core/log.h"
#include "render/draw_state.h"
#include "render/frame.h"
#include "render/light_buffer.h"
#include "render/light_state.h"
#include "render/pixel_rectangle.h"
#include "render/seams.h"
#include "render/shadow_maps.h"
#include "seen_surface.h"

namespace tyndall::translucency {
namespace {

/// The first ring of Shopf's pattern over the transport distance, and over the object's radius at most: the third ring,
/// four times as wide, still meets the object.
constexpr float kRing = 0.25f, kMostRing = 0.12f;

gpu::ProgramDesc program_of(const HtsmPass::Variant& variant, const std::string& name) {
    std::vector<std::string> defines{fmt::format("STEPS {}", variant.steps)};
    if (variant.bends) defines.emplace_back("BENDS");
    if (variant.voxels) defines.emplace_back("OF_VOXELS");
    return {.name = "translucency.htsm." + name,
            .fragment = "translucency/htsm/" + name + ".frag",
            .defines = std::move(defines)};
}

}  // namespace

HtsmPass::HtsmPass(std::shared_ptr<TechniquePlan> plan, const TranslucencySettings& settings)
    : plan_(std::move(plan)), settings_(settings) {}

void HtsmPass::declare(PassDeclaration& declaration) {
    declaration.stage(Stage::diffusion)
        .reads("scene_depth", "where the surfaces are seen")
        .reads("gbuffer_normal", "toward the eye")
        .reads("gbuffer_surface", "which surface is seen")
        .reads("shadow_maps", "where light enters solids", true)
        .updates("light_diffuse", "light that leaves translucent surfaces in place of what arrives there")
        .after("translucency.points");
}

void HtsmPass::execute(PassContext& context) {
    if (settings_.enabled)
        for (const size_t index : plan_->surfaces(context.frame().scene, Technique::htsm)) {
            const Surface& surface = context.frame().scene.surfaces[index];
            Object& object = objects_.of(surface);
            object.paint.set(plan_->paints().of(surface, settings_.model), surface);
            if (object.solid.update(surface, context.frame().scene.time_s, settings_.htsm))
                render(context, surface, float(index + 1), object);
        }
    objects_.end_frame();
}

void HtsmPass::render(PassContext& context, const Surface& surface, float number, Object& object) {
    const PixelRectangle pixels = pixels_of(surface.bounds, context.frame().block.view_projection, context.size());
    if (pixels.empty()) return;
    if (variant_of(surface).voxels) arrive(context, surface, object);
    const std::string_view targets[] = {"light_diffuse"};
    context.bind_targets(targets, -1);
    glEnable(GL_SCISSOR_TEST);
    glScissor(pixels.low.x, pixels.low.y, pixels.size.x, pixels.size.y);
    const RenderScene& scene = context.frame().scene;
    const bool begins = settings_.htsm.form == HtsmForm::physical && (scene.lights.empty() || has_surroundings(scene));
    if (begins) begin(context, surface, number, object);
    add_lights(context, surface, number, object, begins);
    glDisable(GL_SCISSOR_TEST);
}

void HtsmPass::bind(const gpu::Program& program, PassContext& context, const Surface& surface, float number,
                    const Object& object) {
    object.solid.bind(program);
    object.paint.bind(program);
    bind_seen(program, context, surface, number, table_);
}

HtsmPass::Variant HtsmPass::variant_of(const Surface& surface) const {
    const HtsmSettings& s = settings_.htsm;
    return {s.form, s.steps, surface.interior->eta > 1.0f,
            s.form == HtsmForm::physical && s.march == HtsmMarch::voxels};
}

void HtsmPass::begin(PassContext& context, const Surface& surface, float number, const Object& object) {
    Frame& frame = context.frame();
    const gpu::Program& program = frame.shaders.program(program_of(variant_of(surface), "begin"));
    program.use();
    bind_frame(program, frame);
    frame.seams.bind(Seam::indirect_light, program, context);
    bind(program, context, surface, number, object);
    const DrawState state(DepthState::off, BlendState::attenuate_add);
    gpu::draw_fullscreen();
}

std::string HtsmPass::source_of(Frame& frame, size_t light, const Surface& surface, const Solid& solid) const {
    std::string source;
    append_light_state(source, frame, light, objects_.frame());
    append_state(source, surface.transform);
    append_state(source, surface.interior->eta);
    append_state(source, solid.version());
    append_state(source, settings_.htsm.steps);
    return source;
}

void HtsmPass::bind_entries(const gpu::Program& program, PassContext& context) const {
    Frame& frame = context.frame();
    frame.seams.bind(Seam::light_transmittance, program, context);
    if (const gpu::Texture* depths = frame.shadow_maps.texture())
        program.texture("entry_depths", *depths, {.filter = gpu::Filter::linear});
}

/// Marches from the voxels, for lights whose light there may have changed.
void HtsmPass::arrive(PassContext& context, const Surface& surface, Object& object) {
    Frame& frame = context.frame();
    const Variant variant = variant_of(surface);
    gpu::ProgramDesc desc = program_of(variant, "arrive");
    desc.vertex = desc.fragment = "";
    desc.compute = "translucency/htsm/arrive.comp";
    LightPrograms& programs = arrive_programs_.try_emplace(variant, std::move(desc)).first->second;
    programs.begin();
    object.lights.resize(frame.scene.lights.size());
    const glm::ivec3 size = object.solid.size(), groups = (size + glm::ivec3(7, 7, 0)) / glm::ivec3(8, 8, 1);
    const gpu::TextureDesc texture{.shape = gpu::Shape::volume,
                                   .format = gpu::Format::rgba32f,
                                   .width = size.x,
                                   .height = size.y,
                                   .layers = size.z};
    for (size_t i = 0; i < object.lights.size(); ++i) {
        Arriving& arriving = object.lights[i];
        std::string source = source_of(frame, i, surface, object.solid);
        append_state(source, plan_->paints().number(surface, settings_.model));
        if (source == arriving.made_from) continue;
        arriving.made_from = std::move(source);
        for (gpu::Texture* made : {&arriving.light, &arriving.travels})
            if ((made == &arriving.light || variant.bends) && (made->name() == 0 || made->desc() != texture))
                *made = gpu::Texture(texture, "translucency.arriving");
        const gpu::Program& program = programs.use(frame, i, [&](const gpu::Program& fresh) {
            object.solid.bind(fresh);
            object.paint.bind(fresh);
            bind_entries(fresh, context);
        });
        program.set("light_index", unsigned(i));
        program.image("arriving", arriving.light, 0, true);
        if (variant.bends) program.image("travels", arriving.travels, 0, true);
        glDispatchCompute(GLuint(groups.x), GLuint(groups.y), GLuint(groups.z));
        glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    }
}

void HtsmPass::say_unshadowed(Frame& frame, const Surface& surface, Object& object) {
    const auto without = [](const GpuLight& light) { return light.shadow.x == 0.0f; };
    const std::span lights(frame.lights.lights().data(), frame.scene.lights.size());
    if (object.unshadowed || std::ranges::none_of(lights, without)) return;
    object.unshadowed = true;
    log::info(
        "translucency: {}: a light has no shadow map: where its light enters is told by the grid, and nothing "
        "stands in its way",
        surface.material->name);
}

void HtsmPass::add_lights(PassContext& context, const Surface& surface, float number, Object& object, bool begun) {
    Frame& frame = context.frame();
    const Solid& solid = object.solid;
    say_unshadowed(frame, surface, object);
    const DrawState state(DepthState::off, BlendState::attenuate_add);
    const Variant variant = variant_of(surface);
    const char* name = variant.form == HtsmForm::physical ? "physical" : "shopf";
    LightPrograms& programs = programs_.try_emplace(variant, program_of(variant, name)).first->second;
    programs.begin();
    for (size_t i = 0; i < frame.scene.lights.size(); ++i) {
        const gpu::Program& program = programs.use(frame, i, [&](const gpu::Program& fresh) {
            bind(fresh, context, surface, number, object);
            bind_entries(fresh, context);
            fresh.set("rays", whole_pattern(settings_.htsm.rays));
            if (fresh.has("ring_m"))
                fresh.set("ring_m", std::min(kRing * solid.block().transport.w, kMostRing * solid.radius_m()));
        });
        program.set("light_index", unsigned(i));
        if (program.has("keeps")) program.set("keeps", begun || i > 0 ? 1.0f : 0.0f);
        if (variant.voxels) {
            program.texture("arriving", object.lights[i].light, {.filter = gpu::Filter::linear});
            if (variant.bends) program.texture("travels", object.lights[i].travels, {.filter = gpu::Filter::linear});
        }
        gpu::draw_fullscreen();
    }
}

}  // namespace tyndall::translucency
