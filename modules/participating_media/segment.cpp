#include "segment.h"

#include <fmt/format.h>

#include "render/frame.h"
#include "render/seams.h"

namespace tyndall::participating_media {
namespace {

/// As shaders/segment_march.glsl has it: light or -1 environment, -2 emission; medium; 1 = behind the froxels' grid.
std::vector<glm::ivec3> segment_terms(const SolverPlan& plan, const FroxelGrid& grid) {
    std::vector<glm::ivec3> terms;
    for (size_t solver = 0; solver < kSolverCount; ++solver) {
        const bool froxels = static_cast<Solver>(solver) == Solver::froxels;
        if (froxels && grid.complete) continue;
        for (const Term& term : plan.terms(static_cast<Solver>(solver))) {
            const int source = term.source == Term::Source::light         ? static_cast<int>(term.light)
                               : term.source == Term::Source::environment ? -1
                                                                          : -2;
            terms.emplace_back(source, static_cast<int>(term.medium), froxels ? 1 : 0);
        }
    }
    return terms;
}

}  // namespace

void bind_segment(const gpu::Program& program, PassContext& context, MediaBuffer& media, FroxelVolume& froxels,
                  const MediaSettings& settings) {
    media.bind(program, settings.eye_steps);
    program.texture("media_in_scatter", context.texture("media_in_scatter"), {.filter = gpu::Filter::nearest});
    if (!program.has("segment_steps")) return;  // MEDIA_SEGMENT_OF_SURFACE
    context.frame().seams.bind(Seam::light_transmittance, program, context);
    media.environment().bind(program);
    froxels.bind(program);
    program.texture("phase_tables", media.phase_tables(), {.filter = gpu::Filter::linear});
    std::vector<glm::ivec3> terms = segment_terms(media.plan(), froxels.grid);
    if (terms.size() > kMaximumSegmentTerms) {
        media.warn_once(fmt::format("all pairs of a light and a medium after the first {} before transparent things",
                                    kMaximumSegmentTerms));
        terms.resize(kMaximumSegmentTerms);
    }
    program.set("segment_term_count", static_cast<int>(terms.size()));
    for (size_t i = 0; i < terms.size(); ++i) program.set(fmt::format("segment_terms[{}]", i), terms[i]);
    program.set("segment_steps", settings.steps);
}

}  // namespace tyndall::participating_media
