#include "froxels/froxel_pass.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include "media_textures.h"
#include "render/frame.h"
#include "render/seams.h"

namespace tyndall::participating_media {
namespace {

constexpr int kReferenceSamples = 16;

const gpu::Program& compute(PassContext& context, std::string_view shader, std::vector<std::string> defines = {}) {
    const gpu::Program& program =
        context.frame().shaders.program({.name = fmt::format("participating_media.froxels.{}", shader),
                                         .compute = fmt::format("participating_media/froxels/{}.comp", shader),
                                         .defines = std::move(defines)});
    program.use();
    bind_frame(program, context.frame());
    return program;
}

}  // namespace

std::string froxels_cannot(const RenderScene&, const Medium&, const Term&) {
    return {};
}

void FroxelPass::declare(PassDeclaration& declaration) {
    declaration.stage(Stage::media)
        .reads("scene_depth", "where rays end")
        .updates("media_in_scatter", "adds the light that the froxels gathered")
        .after("participating_media.god_rays");
}

void FroxelPass::execute(PassContext& context) {
    Frame& frame = context.frame();
    volume_->active = !terms().empty();
    if (!volume_->active) {
        history_.forget();
        return;
    }
    if (blue_noise_.name() == 0) blue_noise_ = make_blue_noise();
    volume_->grid = fit_grid(settings_.froxels, frame, media_->media(), terms());
    const bool fresh = volume_->make(keeps_history());
    history_.update(frame, *media_, terms(), volume_->grid, keeps_history() && !fresh);
    if (history_.kind() == 1) volume_->now = 1 - volume_->now;
    find_columns(context);
    begin_sources(context);
    add_lights(context);
    add_glow(context, Term::Source::emission);
    add_glow(context, Term::Source::environment);
    integrate(context);
    apply(context);
}

void FroxelPass::dispatch(const glm::ivec3& froxels) const {
    const int slices = volume_->slices_a_thread();
    glDispatchCompute(static_cast<GLuint>((froxels.x + 7) / 8), static_cast<GLuint>((froxels.y + 7) / 8),
                      static_cast<GLuint>((froxels.z + slices - 1) / slices));
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

void FroxelPass::find_columns(PassContext& context) {
    const glm::ivec2 columns(volume_->grid.size), size = context.size();
    const gpu::Program& program = compute(context, "columns");
    volume_->bind_grid(program);
    program.texture("scene_depth", context.texture("scene_depth"), {.filter = gpu::Filter::nearest});
    program.image("froxel_columns", volume_->columns, 0, true);
    const glm::ivec2 uneven(size.x % columns.x != 0 ? 1 : 0, size.y % columns.y != 0 ? 1 : 0);
    program.set("pixels", glm::max(size / columns, glm::ivec2(1)) + uneven);
    dispatch({columns, 1});
    const gpu::Program& reach = compute(context, "reach");
    volume_->bind_grid(reach);
    reach.image("froxel_columns", volume_->columns, 0, false);
    reach.image("froxel_reach", volume_->reach, 0, true);
    dispatch({columns, 1});
}

void FroxelPass::begin_sources(PassContext& context) {
    const gpu::Program& program = compute(context, "begin", {fmt::format("HISTORY {}", history_.kind())});
    volume_->bind_grid(program);
    history_.bind(program);
    program.image("froxel_source", volume_->source[volume_->now], 0, true);
    program.image("froxel_reach", volume_->reach, 0, false);
    if (history_.kind() == 1)
        program.texture("history", volume_->source[1 - volume_->now], {.filter = gpu::Filter::linear});
    dispatch(volume_->grid.size);
}

void FroxelPass::bind_samples(const gpu::Program& program, PassContext& context) const {
    const FroxelSettings& settings = settings_.froxels;
    const int alone = settings.reference ? kReferenceSamples : settings.samples_alone;
    volume_->bind_grid(program);
    media_->bind(program, settings_.light_steps);
    program.image("froxel_source", volume_->source[volume_->now], 0, true);
    program.texture("scene_depth", context.texture("scene_depth"), {.filter = gpu::Filter::nearest});
    program.image("froxel_columns", volume_->columns, 0, false);
    program.image("froxel_reach", volume_->reach, 0, false);
    program.texture("phase_tables", media_->phase_tables(), {.filter = gpu::Filter::linear});
    program.image("blue_noise", blue_noise_, 0, false);
    program.set("samples", settings.samples);
    program.set("samples_alone", alone);
    program.set("first_sample",
                keeps_history() ? static_cast<int>(context.frame().scene.frame % 4096) * settings.samples : 0);
}

void FroxelPass::add_lights(PassContext& context) {
    LightPrograms& programs = light_programs_.of(common_phase(*media_, terms()));
    programs.begin();
    for (size_t light = 0; light < context.frame().scene.lights.size(); ++light)
        if (const unsigned bits = media_bits(terms(), Term::Source::light, light); bits != 0)
            add_light(context, programs, light, bits);
}

void FroxelPass::add_light(PassContext& context, LightPrograms& programs, size_t light, unsigned bits) {
    Frame& frame = context.frame();
    const FroxelBox box = light_box(volume_->grid, frame.scene.lights[light], frame.block);
    if (box.empty()) return;
    const gpu::Program& program = programs.use(frame, light, [&](const gpu::Program& fresh) {
        frame.seams.bind(Seam::light_transmittance, fresh, context);
        bind_samples(fresh, context);
    });
    program.set("light_index", static_cast<unsigned>(light));
    program.set("light_media", bits);
    program.set("box_low", box.low);
    program.set("box_size", box.size);
    dispatch(box.size);
}

void FroxelPass::add_glow(PassContext& context, Term::Source source) {
    const unsigned bits = media_bits(terms(), source);
    if (bits == 0) return;
    const bool own = source == Term::Source::emission;
    const gpu::Program& program =
        compute(context, own ? "emission" : "environment", phase_defines(common_phase(*media_, terms())));
    if (!own) media_->environment().bind(program);
    bind_samples(program, context);
    program.set(own ? "glowing_media" : "lit_media", bits);
    dispatch(volume_->grid.size);
}

void FroxelPass::integrate(PassContext& context) {
    const gpu::Program& program = compute(context, "integrate", phase_defines(common_phase(*media_, terms())));
    volume_->bind_grid(program);
    media_->bind(program, settings_.light_steps);
    program.image("froxel_source", volume_->source[volume_->now], 0, false);
    program.image("froxel_radiance", volume_->radiance, 0, true);
    program.image("froxel_reach", volume_->reach, 0, false);
    const glm::ivec2 columns(volume_->grid.size);
    dispatch({columns, 1});
}

void FroxelPass::apply(PassContext& context) {
    const gpu::Program& program = compute(context, "apply");
    volume_->bind_grid(program);
    program.texture("scene_depth", context.texture("scene_depth"), {.filter = gpu::Filter::nearest});
    program.image("froxel_radiance", volume_->radiance, 0, false);
    program.image("froxel_columns", volume_->columns, 0, false);
    program.image("media_in_scatter", context.texture("media_in_scatter"), 0, true);
    dispatch({context.size(), 1});
    glMemoryBarrier(GL_FRAMEBUFFER_BARRIER_BIT);
    if (volume_->grid.complete) return;
    context.bind_targets();
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE);  // the distance stays
    beyond_.draw(context, *media_, *volume_, settings_.light_steps);
    glDisable(GL_BLEND);
}

}  // namespace tyndall::participating_media
