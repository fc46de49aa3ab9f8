#include "transmission/transmission_pass.h"

#include <algorithm>
#include <glm/common.hpp>

#include "render/frame.h"
#include "render/light_buffer.h"
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
    }
    return seen;
}

}  // namespace

TransmissionPass::TransmissionPass(std::shared_ptr<SkinTables> tables, const SkinSettings& settings, SpreadIn spread)
    : tables_(std::move(tables)),
      settings_(settings),
      spread_(spread),
      programs_({.name = "skin.transmission", .fragment = "skin/transmission/transmission.frag"}) {}

void TransmissionPass::declare(PassDeclaration& declaration) {
    declaration.stage(Stage::diffusion)
        .reads("scene_depth", "where the skin is")
        .reads("gbuffer_normal", "how rough it is")
        .reads("gbuffer_surface", "which skin is seen, and its plane")
        .reads("shadow_maps", "where light enters")
        .updates("light_diffuse", "light that came through thin parts");
    if (spread_ == SpreadIn::map) declaration.after("skin.texture_space");
}

void TransmissionPass::execute(PassContext& context) {
    static constexpr std::string_view kTargets[] = {"light_diffuse", "scene_depth"};
    if (!settings_.enabled) return;
    const Seen seen = seen_skin(context, spread_);
    if (seen.empty()) return;
    Frame& frame = context.frame();
    context.bind_targets(kTargets, -1);
    const Within within(seen.low, seen.high, seen.far, BlendState::add);
    programs_.begin();
    for (size_t i = 0; i < frame.scene.lights.size(); ++i) {
        if (!(frame.lights.lights()[i].shadow.x > 0.0f)) continue;
        const gpu::Program& program = programs_.use(frame, i, [&](const gpu::Program& fresh) {
            for (const char* target : {"scene_depth", "gbuffer_normal", "gbuffer_surface"})
                fresh.texture(target, context.texture(target), {.filter = gpu::Filter::nearest});
            frame.seams.bind(Seam::light_transmittance, fresh, context);
            tables_->bind(fresh, frame.scene);
            shares_.bind(fresh, frame.scene);
            fresh.texture("skin_shadow_depths", *frame.shadow_maps.texture(), {.filter = gpu::Filter::linear});
        });
        program.set("first_map_technique", float(Technique::six_gaussians));
        program.set("in_maps", spread_ == SpreadIn::map ? 1.0f : 0.0f);
        program.set("light_index", unsigned(i));
        gpu::draw_fullscreen();
    }
}

}  // namespace tyndall::skin
