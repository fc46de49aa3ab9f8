#include "analytic/surface_glow.h"

#include <fmt/format.h>

#include "analytic/glow_table.h"

namespace tyndall::participating_media {
namespace {

constexpr size_t kMostLamps = 32;  ///< as in shaders/analytic/surface_glow.glsl
}  // namespace

void SurfaceGlow::bind(const gpu::Program& program, const RenderScene& scene, const MediaBuffer& media,
                       const MediaSettings& settings) {
    if (!program.has("glow_lamp_count")) return;
    size_t count = 0;
    for (const Term& term : media.plan().terms(Solver::analytic)) {
        if (!settings.analytic.surface_glow || count == kMostLamps) break;
        const Medium& medium = media.media()[term.medium];
        const Light& light = scene.lights[term.light];
        if (light.kind != LightKind::point || !std::holds_alternative<ConstantDensity>(medium.density)) continue;
        program.set(fmt::format("glow_lamps[{}]", count), glm::vec4(glm::vec3(light.transform[3]), term.medium));
        program.set(fmt::format("glow_intensities[{}]", count++), light.intensity);
    }
    if (count > 0 && table_.name() == 0) {
        table_ = gpu::Texture({.shape = gpu::Shape::volume,
                               .format = gpu::Format::r32f,
                               .width = GlowTable::kDistances,
                               .height = GlowTable::kAngles,
                               .layers = GlowTable::kLayers},
                              "participating_media.surface_glow");
        const GlowTable table = make_glow_table();
        for (int layer = 0; layer < GlowTable::kLayers; ++layer)
            table_.upload(0, layer, table.values.data() + layer * GlowTable::kAngles * GlowTable::kDistances);
    }
    program.set("glow_lamp_count", static_cast<int>(count));
    program.texture("glow_table", table_.name() != 0 ? table_ : media.grids(), {.filter = gpu::Filter::linear});
}

}  // namespace tyndall::participating_media
