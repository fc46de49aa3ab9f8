#include "epipolar/epipolar_pass.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

#include "epipolar/epipole.h"
#include "render/draw_state.h"
#include "render/light_buffer.h"
#include "render/shadow_maps.h"

namespace tyndall::participating_media {
namespace {

constexpr int kGroup = 64;  // as in the shaders

/// Six shadow maps: no line of one map holds a slice.
bool has_cube(const Light& light) {
    constexpr float kWidestCone = 1.309f;  // render/shadow_views.cpp
    return light.kind == LightKind::point || (light.kind == LightKind::spot && light.outer_angle >= kWidestCone);
}

/// The light's only or widest view; -1 = it casts no shadows.
int shadow_view_index(const Frame& frame, size_t light) {
    return static_cast<int>(frame.lights.lights()[light].shadow.x) - 1;
}

int power_of_two_below(int value) {
    return static_cast<int>(std::bit_floor(static_cast<unsigned>(std::max(value, 1))));
}

}  // namespace

std::string epipolar_cannot(const RenderScene& scene, const Medium&, const Term& term) {
    if (term.source != Term::Source::light) return "renders the light of lamps and suns only";
    if (has_cube(scene.lights[term.light])) return "cannot render point lights and spots wider than 150 degrees";
    return {};
}

void EpipolarPass::declare(PassDeclaration& declaration) {
    declaration.stage(Stage::media)
        .reads("scene_depth", "where rays end")
        .reads("shadow_maps", "where light ends")
        .updates("media_in_scatter", "adds what lights scatter")
        .after("participating_media.light_volumes");
}

int EpipolarPass::initial_step() const {
    constexpr int kLongestUneven = 4;
    const int step = power_of_two_below(settings_.epipolar.initial_step);
    return media_->even() ? step : std::min(step, kLongestUneven);
}
int EpipolarPass::shadow_samples() const {
    return power_of_two_below(settings_.epipolar.shadow_samples);
}
int EpipolarPass::samples() const {
    return std::max(settings_.epipolar.samples / initial_step(), 1) * initial_step() + 1;
}

void EpipolarPass::make_targets() {
    const int slices = settings_.epipolar.slices;
    const gpu::TextureDesc lines = targets_.lines.desc();
    if (targets_.lines.name() != 0 && lines.width == slices && lines.height == samples() &&
        targets_.tree.desc().height == 2 * shadow_samples())
        return;
    const auto make = [&](gpu::Format format, int rows, std::string_view label) {
        return gpu::Texture({.format = format, .width = slices, .height = rows}, label);
    };
    targets_ = {};
    targets_.ends = make(gpu::Format::rgba32f, 2, "epipolar ends");
    targets_.distances = make(gpu::Format::r32f, samples(), "epipolar distances");
    targets_.sources = make(gpu::Format::rg32f, samples(), "epipolar sources");
    targets_.tree = make(gpu::Format::rg32f, 2 * shadow_samples(), "epipolar tree");
    targets_.looks = make(gpu::Format::rgba32f, samples(), "epipolar looks");
    targets_.lines = make(gpu::Format::rgba32f, samples(), "epipolar lines");
    targets_.looks.clear(0, glm::vec4(0.0f));
}

void EpipolarPass::execute(PassContext& context) {
    const SolverPlan& plan = media_->plan();
    if (!plan.uses(Solver::epipolar)) return;
    make_targets();
    for (const Term& term : plan.terms(Solver::epipolar)) draw_term(context, term);
}

void EpipolarPass::dispatch(int rows) const {
    glDispatchCompute(static_cast<GLuint>((settings_.epipolar.slices + kGroup - 1) / kGroup),
                      static_cast<GLuint>(std::max(rows, 1)), 1);
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

void EpipolarPass::draw_term(PassContext& context, const Term& term) {
    if (!settings_.epipolar.brute_force) make_lines(context, term);
    context.bind_targets();
    use(context, Step::unwarp, term);
    const DrawState state(DepthState::off, BlendState::add);
    gpu::draw_fullscreen();
}

void EpipolarPass::make_lines(PassContext& context, const Term& term) {
    use(context, Step::slices, term);
    dispatch(1);
    use(context, Step::distances, term);
    dispatch(samples());
    use(context, Step::sources, term);
    dispatch(samples() / initial_step() + 1);
    if (shadow_view_index(context.frame(), term.light) >= 0) make_tree(context, term);
    use(context, Step::march, term);
    dispatch(samples());
    use(context, Step::interpolate, term);
    dispatch(samples());
}

void EpipolarPass::make_tree(PassContext& context, const Term& term) {
    Frame& frame = context.frame();
    const auto view = static_cast<size_t>(shadow_view_index(frame, term.light));
    const gpu::Program& leaves = use(context, Step::tree_leaves, term);
    leaves.texture("shadow_depths", *frame.shadow_maps.texture(), {.filter = gpu::Filter::nearest});
    leaves.set("page", frame.lights.lights()[term.light].views[view].texel_page_fades.y);
    dispatch(shadow_samples());
    const gpu::Program& program = use(context, Step::tree, term);
    for (int level = 1, nodes = shadow_samples() / 2; nodes > 0; ++level, nodes /= 2) {
        program.set("level", level);
        dispatch(nodes);
    }
}

const gpu::Program& EpipolarPass::use(PassContext& context, Step step, const Term& term) {
    Frame& frame = context.frame();
    const bool looks_at_media = step == Step::march || step == Step::unwarp;
    const PhaseKind phase = looks_at_media ? media_->media()[term.medium].phase.kind : PhaseKind{};
    LightPrograms& variants = programs_.at(static_cast<size_t>(step)).of(phase, {settings_.epipolar.steps});
    variants.begin();
    const gpu::Program& program = variants.use(frame, term.light, [&](const gpu::Program& fresh) {
        if (looks_at_media) bind_light_source(fresh, context, *media_, settings_.light_steps);
    });
    const EpipolarSettings& settings = settings_.epipolar;
    const int view = shadow_view_index(frame, term.light);
    program.set("light_index", static_cast<unsigned>(term.light));
    program.set("medium", static_cast<int>(term.medium));
    program.set("farthest", kFarthest);
    program.set("slices", settings.slices);
    program.set("samples", samples());
    program.set("shadow_samples", shadow_samples());
    program.set("shadow_view_index", step == Step::march ? view : std::max(view, 0));
    program.set("coarsest", settings.tree ? std::countr_zero(static_cast<unsigned>(shadow_samples())) : 0);
    program.set("initial_step", initial_step());
    program.set("threshold", settings.refinement_threshold);
    program.set("steps", settings.steps);
    program.set("brute_force", settings.brute_force ? 1 : 0);
    program.set("epipole", epipole(frame.scene.lights[term.light], frame.block.view_projection, context.size()));
    const gpu::SamplerDesc nearest{.filter = gpu::Filter::nearest};
    program.texture("scene_depth", context.texture("scene_depth"), nearest);
    if (step == Step::unwarp) {
        program.texture("lines", targets_.lines, nearest);
        program.texture("slice_ends", targets_.ends, nearest);
        return program;
    }
    program.image("slice_ends", targets_.ends, 0, step == Step::slices);
    program.image("distances", targets_.distances, 0, step == Step::distances);
    program.image("sources", targets_.sources, 0, step == Step::sources);
    program.image("tree", targets_.tree, 0, step == Step::tree_leaves || step == Step::tree);
    program.image("looks", targets_.looks, 0, step == Step::march);
    program.image("lines", targets_.lines, 0, step == Step::interpolate);
    return program;
}

std::vector<MediaPrograms> EpipolarPass::make_programs() {
    const auto compute = [](std::string_view name, std::vector<std::string> defines = {},
                            std::vector<std::string> numbers = {}) {
        return MediaPrograms({.name = fmt::format("participating_media.epipolar_{}", name),
                              .compute = fmt::format("participating_media/epipolar/{}.comp", name),
                              .defines = std::move(defines)},
                             std::move(numbers));
    };
    return {compute("slices"),
            compute("distances"),
            compute("sources"),
            compute("tree", {"FIRST_LEVEL"}),
            compute("tree"),
            compute("march", {"IGNORE_SHADOW_MAPS"}, {"STEPS"}),
            compute("interpolate"),
            MediaPrograms({.name = "participating_media.epipolar_unwarp",
                           .fragment = "participating_media/epipolar/unwarp.frag"})};
}

}  // namespace tyndall::participating_media
