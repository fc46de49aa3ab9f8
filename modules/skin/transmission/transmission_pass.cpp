#include "transmission/transmission_pass.h"

#include <algorithm>
#include <glm/common.hpp>

#include "render/frame.h"
#include "render/light_buffer.h"
#include "render/light_state.h"
#include "render/pixel_rectangle.h"
#include "render/seams.h"
#include "render/shadow_maps.h"
#include "seen_rectangle.h"

namespace tyndall::skin {
namespace {

/// Where skin that lets light through can be seen.
struct Seen {
    glm::ivec2 low{0}, high{0};
    float far = 1.0f;
    float thickness_use = 0.0f;  ///< the largest of thickness_use()
    bool by_depth = false;       ///< of some of it shadow maps' depths say it
    [[nodiscard]] bool empty() const { return high == glm::ivec2(0); }
};

bool in_map(const SurfaceDiffusion& diffusion) {
    return technique_of(diffusion) >= Technique::six_gaussians;
}

Seen seen_skin(PassContext& context, SpreadIn spread) {
    const Frame& frame = context.frame();
    Seen seen{context.size()};
    for (const Surface& surface : frame.scene.surfaces) {
        if (!surface.diffusion || !(surface.diffusion->transmission > 0.0f) ||
            in_map(*surface.diffusion) != (spread == SpreadIn::map))
            continue;
        const PixelRectangle pixels = pixels_of(surface.bounds, frame.block.view_projection, context.size());
        if (pixels.empty()) continue;
        seen.low = glm::min(seen.low, pixels.low);
        seen.high = glm::max(seen.high, pixels.low + pixels.size);
        seen.far = std::min(seen.far, far_depth(surface.bounds, frame));
        seen.thickness_use = std::max(seen.thickness_use, thickness_use(*surface.diffusion));
        seen.by_depth = seen.by_depth || thickness_use(*surface.diffusion) < 2.0f;
    }
    return seen;
}

}  // namespace

TransmissionPass::TransmissionPass(std::shared_ptr<SkinTables> tables, const SkinSettings& settings, SpreadIn spread)
    : tables_(std::move(tables)),
      settings_(settings),
      spread_(spread),
      ring_programs_({.name = "skin.transmission", .fragment = "skin/transmission/transmission.frag"}),
      slab_programs_({.name = "skin.slab", .fragment = "skin/transmission/slab.frag"}) {}

void TransmissionPass::declare(PassDeclaration& declaration) {
    declaration.stage(Stage::diffusion)
        .reads("scene_depth", "where the skin is")
        .reads("gbuffer_normal", "how rough it is")
        .reads("gbuffer_surface", "which skin is seen, and its plane")
        .reads("skin_pixels", "how thick it is, where that is known")
        .reads("shadow_maps", "where light enters")
        .updates("light_diffuse", "light that came through thin parts");
    if (spread_ == SpreadIn::map) declaration.after("skin.texture_space");
}

void TransmissionPass::execute(PassContext& context) {
    static constexpr std::string_view kTargets[] = {"light_diffuse", "scene_depth"};
    if (!settings_.enabled) return;
    const Seen seen = seen_skin(context, spread_);
    if (seen.empty()) return;
    context.bind_targets(kTargets, -1);
    const Within within(seen.low, seen.high, seen.far, BlendState::add);
    if (seen.by_depth) rings(context);
    if (seen.thickness_use > 0.0f) {
        slabs(context, seen.thickness_use);
        around(context);
    }
}

/// What all of the programs have in common.
void TransmissionPass::bind(PassContext& context, const gpu::Program& program, float least_use) {
    const Frame& frame = context.frame();
    for (const char* target : {"scene_depth", "gbuffer_normal", "gbuffer_surface"})
        program.texture(target, context.texture(target), {.filter = gpu::Filter::nearest});
    if (least_use > 0.0f)
        program.texture("skin_pixels", context.texture("skin_pixels"), {.filter = gpu::Filter::nearest});
    tables_->bind(program, frame.scene);
    shares_.bind(program, frame.scene);
    program.set("first_map_technique", float(Technique::six_gaussians));
    program.set("in_maps", spread_ == SpreadIn::map ? 1.0f : 0.0f);
    program.set("least_use", least_use);
}

/// Lights with shadow maps, by their depths.
void TransmissionPass::rings(PassContext& context) {
    Frame& frame = context.frame();
    ring_programs_.begin();
    for (size_t i = 0; i < frame.scene.lights.size(); ++i) {
        if (!(frame.lights.lights()[i].shadow.x > 0.0f)) continue;
        const gpu::Program& program = ring_programs_.use(frame, i, [&](const gpu::Program& fresh) {
            bind(context, fresh, 0.0f);
            frame.seams.bind(Seam::light_transmittance, fresh, context);
            fresh.texture("skin_shadow_depths", *frame.shadow_maps.texture(), {.filter = gpu::Filter::linear});
        });
        program.set("light_index", unsigned(i));
        gpu::draw_fullscreen();
    }
}

/// Lights by the body's thickness: those without shadow maps, and all where a surface wants it.
void TransmissionPass::slabs(PassContext& context, float largest_use) {
    Frame& frame = context.frame();
    slab_programs_.begin();
    for (size_t i = 0; i < frame.scene.lights.size(); ++i) {
        const float least_use = frame.lights.lights()[i].shadow.x > 0.0f ? 2.0f : 1.0f;
        if (largest_use < least_use) continue;
        const gpu::Program& program = slab_programs_.use(frame, i, [&](const gpu::Program& fresh) {
            bind(context, fresh, least_use);
            frame.seams.bind(Seam::light_transmittance, fresh, context);
        });
        program.set("least_use", least_use);
        program.set("light_index", unsigned(i));
        gpu::draw_fullscreen();
    }
}

/// Light that comes from no light source, by the body's thickness.
void TransmissionPass::around(PassContext& context) {
    static const gpu::ProgramDesc kDesc{.name = "skin.around", .fragment = "skin/transmission/around.frag"};
    Frame& frame = context.frame();
    if (!has_light_all_around(frame.scene) && frame.seams.providers(Seam::indirect_light).size() <= 1) return;
    const gpu::Program& program = frame.shaders.program(kDesc);
    program.use();
    bind_frame(program, frame);
    bind(context, program, 1.0f);
    frame.seams.bind(Seam::indirect_light, program, context);
    gpu::draw_fullscreen();
}

}  // namespace tyndall::skin
