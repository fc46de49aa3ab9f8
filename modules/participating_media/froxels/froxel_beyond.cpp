#include "froxels/froxel_beyond.h"

#include <algorithm>

#include "render/frame.h"
#include "render/seams.h"

namespace tyndall::participating_media {

unsigned media_bits(const std::vector<Term>& terms, Term::Source source, size_t light) {
    unsigned bits = 0;
    for (const Term& term : terms)
        if (term.source == source && (source != Term::Source::light || term.light == light)) bits |= 1u << term.medium;
    return bits;
}

std::optional<PhaseKind> common_phase(const MediaBuffer& media, const std::vector<Term>& terms) {
    const auto kind = [&](const Term& term) { return media.media()[term.medium].phase.kind; };
    if (!std::ranges::all_of(terms, [&](const Term& term) { return kind(term) == kind(terms.front()); })) return {};
    return kind(terms.front());
}

namespace {

void bind(const gpu::Program& program, PassContext& context, const MediaBuffer& media, const FroxelVolume& volume,
          int light_steps) {
    volume.bind_grid(program);
    media.bind(program, light_steps);
    program.texture("phase_tables", media.phase_tables(), {.filter = gpu::Filter::linear});
    program.texture("scene_depth", context.texture("scene_depth"), {.filter = gpu::Filter::nearest});
}

}  // namespace

void FroxelBeyond::draw_light(PassContext& context, const MediaBuffer& media, const FroxelVolume& volume,
                              int light_steps, size_t light) {
    Frame& frame = context.frame();
    const std::vector<Term>& terms = media.plan().terms(Solver::froxels);
    const unsigned bits = media_bits(terms, Term::Source::light, light);
    if (bits == 0) return;
    LightPrograms& programs = lights_.of(common_phase(media, terms));
    programs.begin();
    const gpu::Program& program = programs.use(frame, light, [&](const gpu::Program& fresh) {
        frame.seams.bind(Seam::light_transmittance, fresh, context);
        bind(fresh, context, media, volume, light_steps);
    });
    program.set("light_index", static_cast<unsigned>(light));
    program.set("beyond_media", bits);
    gpu::draw_fullscreen();
}

void FroxelBeyond::draw(PassContext& context, const MediaBuffer& media, const FroxelVolume& volume, int light_steps) {
    Frame& frame = context.frame();
    const std::vector<Term>& terms = media.plan().terms(Solver::froxels);
    for (size_t light = 0; light < frame.scene.lights.size(); ++light)
        draw_light(context, media, volume, light_steps, light);
    const unsigned glowing = media_bits(terms, Term::Source::emission);
    const unsigned lit = media_bits(terms, Term::Source::environment);
    if ((glowing | lit) == 0) return;
    const gpu::Program& program = frame.shaders.program({.name = "participating_media.froxels.beyond_glow",
                                                         .fragment = "participating_media/froxels/beyond_glow.frag",
                                                         .defines = phase_defines(common_phase(media, terms))});
    program.use();
    bind_frame(program, frame);
    bind(program, context, media, volume, light_steps);
    media.environment().bind(program);
    program.set("beyond_media", glowing | lit);
    program.set("glowing_media", glowing);
    program.set("lit_media", lit);
    gpu::draw_fullscreen();
}

}  // namespace tyndall::participating_media
