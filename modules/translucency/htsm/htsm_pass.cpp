#include "htsm/htsm_pass.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>

#include "render/draw_state.h"
#include "render/frame.h"
#include "render/gpu_scene.h"
#include "render/seams.h"
#include "render/shadow_maps.h"

namespace tyndall::translucency {
namespace {

constexpr uint64_t kKeptFrames = 120;
const std::vector<std::string> kAllAround{"ALL_AROUND"}, kNothing;
/// The first ring of Shopf's pattern over the transport distance, and over the object's radius at most: the third ring,
/// four times as wide, still meets the object.
constexpr float kRing = 0.25f, kMostRing = 0.12f;

gpu::ProgramDesc program_of(const HtsmPass::Variant& variant, const std::string& name,
                            const std::vector<std::string>& more = {}) {
    std::vector<std::string> defines = more;
    defines.push_back(fmt::format("STEPS {}", variant.steps));
    if (variant.bends) defines.emplace_back("BENDS");
    return {.name = "translucency.htsm." + name,
            .vertex = "translucency/htsm/surface.vert",
            .fragment = "translucency/htsm/" + name + ".frag",
            .defines = std::move(defines)};
}

bool has_light_all_around(const RenderScene& scene) {
    return !scene.probes.empty() || scene.sky.image || scene.sky.radiance != glm::vec3(0.0f);
}

}  // namespace

HtsmPass::HtsmPass(std::shared_ptr<TechniquePlan> plan, const TranslucencySettings& settings)
    : plan_(std::move(plan)),
      settings_(settings) {}

void HtsmPass::declare(PassDeclaration& declaration) {
    declaration.stage(Stage::diffusion)
        .reads("scene_depth", "where the surfaces are seen")
        .reads("gbuffer_normal", "toward the eye")
        .reads("shadow_maps", "where light enters solids", true)
        .updates("light_diffuse", "light that leaves translucent surfaces in place of what arrives there")
        .after("translucency.points");
}

void HtsmPass::execute(PassContext& context) {
    ++frame_;
    if (settings_.enabled)
        for (const size_t index : plan_->surfaces(context.frame().scene, Technique::htsm)) {
            const Surface& surface = context.frame().scene.surfaces[index];
            Object& object = object_of(surface);
            if (object.solid.update(surface, context.frame().scene.time_s, settings_.htsm))
                render(context, surface, object.solid);
        }
    std::erase_if(objects_, [&](const auto& entry) { return entry.second.last_used + kKeptFrames < frame_; });
}

HtsmPass::Object& HtsmPass::object_of(const Surface& surface) {
    const uint64_t entity = uint64_t(surface.entity.index) << 32u | surface.entity.generation;
    Object& object = objects_[{entity, surface.mesh->id}];
    object.last_used = frame_;
    return object;
}

void HtsmPass::render(PassContext& context, const Surface& surface, const Solid& solid) {
    context.bind_targets();
    const bool mirrored = glm::determinant(glm::mat3(surface.transform)) < 0.0f;
    glEnable(GL_CULL_FACE);
    glFrontFace(mirrored ? GL_CW : GL_CCW);
    // his formula adds to the light that the surface itself returns
    if (settings_.htsm.form == HtsmForm::physical) begin(context, surface, solid);
    add_lights(context, surface, solid);
    glDisable(GL_CULL_FACE);
    glFrontFace(GL_CCW);
}

void HtsmPass::bind(const gpu::Program& program, PassContext& context, const Surface& surface,
                    const Solid& solid) {
    solid.bind(program);
    table_.bind(program);
    for (const char* target : {"scene_depth", "gbuffer_normal"})
        program.texture(target, context.texture(target), {.filter = gpu::Filter::nearest});
    const Material& boundary = *surface.material;
    program.set("boundary_base", glm::vec4(glm::vec3(boundary.base_colour), boundary.ior));
    program.set("boundary_mirror", glm::vec4(boundary.specular_colour, boundary.specular));
    program.set("world_from_local", surface.transform);
    program.set("clip_from_world", context.frame().block.view_projection);
}

HtsmPass::Variant HtsmPass::variant_of(const Surface& surface) const {
    return {settings_.htsm.form, settings_.htsm.steps, surface.interior->eta > 1.0f};
}

void HtsmPass::begin(PassContext& context, const Surface& surface, const Solid& solid) {
    Frame& frame = context.frame();
    const bool all_around = has_light_all_around(frame.scene);
    const gpu::Program& program =
        frame.shaders.program(program_of(variant_of(surface), "begin", all_around ? kAllAround : kNothing));
    program.use();
    bind_frame(program, frame);
    if (all_around) frame.seams.bind(Seam::indirect_light, program, context);
    bind(program, context, surface, solid);
    const DrawState state(DepthState::off, BlendState::attenuate_add);
    frame.gpu_scene.draw_mesh(*surface.mesh);
}

void HtsmPass::add_lights(PassContext& context, const Surface& surface, const Solid& solid) {
    Frame& frame = context.frame();
    const DrawState state(DepthState::off, BlendState::add);
    const Variant variant = variant_of(surface);
    const char* name = variant.form == HtsmForm::physical ? "physical" : "shopf";
    LightPrograms& programs = programs_.try_emplace(variant, program_of(variant, name)).first->second;
    programs.begin();
    const gpu::Texture* depths = frame.shadow_maps.texture();
    for (size_t i = 0; i < frame.scene.lights.size(); ++i) {
        const gpu::Program& program = programs.use(frame, i, [&](const gpu::Program& fresh) {
            frame.seams.bind(Seam::light_transmittance, fresh, context);
            bind(fresh, context, surface, solid);
            if (depths) fresh.texture("entry_depths", *depths, {.filter = gpu::Filter::linear});
            fresh.set("rays", whole_pattern(settings_.htsm.rays));
            if (fresh.has("ring_m"))
                fresh.set("ring_m",
                          std::min(kRing * solid.block().transport.w, kMostRing * solid.radius_m()));
        });
        program.set("light_index", unsigned(i));
        frame.gpu_scene.draw_mesh(*surface.mesh);
    }
}

}  // namespace tyndall::translucency
