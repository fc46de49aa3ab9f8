#include "march/march_terms.h"

#include <epoxy/gl.h>

#include <algorithm>

#include "light_rectangle.h"
#include "media_textures.h"
#include "render/frame.h"

namespace tyndall::participating_media {

int pixel_step(Resolution resolution) {
    switch (resolution) {
        case Resolution::full:
            return 1;
        case Resolution::half:
            return 2;
        case Resolution::quarter:
            return 4;
    }
    return 1;
}

gpu::ProgramDesc MarchTerms::describe(Way way, const std::string& what) {
    const std::string shader = "participating_media/march/" + what + ".glsl";
    switch (way) {
        case Way::marched:
            return {.name = "participating_media." + what, .fragment = shader};
        case Way::guide_only:
            return {.name = "participating_media." + what + "_guide", .fragment = shader, .defines = {"GUIDE_ONLY"}};
        case Way::spread:
            return {.name = "participating_media." + what + "_spread",
                    .compute = shader,
                    .defines = {"GUIDE_ONLY", "SPREAD"}};
        case Way::listed:
            return {.name = "participating_media." + what + "_listed", .compute = shader, .defines = {"LISTED"}};
    }
    return {};
}

MarchTerms::MarchTerms(std::shared_ptr<MediaBuffer> media, const MediaSettings& settings)
    : media_(std::move(media)),
      settings_(settings),
      programs_{MediaPrograms(describe(Way::marched, "march"), {"SHADOW_MIPS"}),
                MediaPrograms(describe(Way::guide_only, "march"), {"SHADOW_MIPS"}),
                MediaPrograms(describe(Way::spread, "march"), {"SHADOW_MIPS", "MEDIA_END"}),
                MediaPrograms(describe(Way::listed, "march"), {"SHADOW_MIPS"})} {}

void MarchTerms::march(PassContext& context) {
    if (settings_.temporal) history_.update(context.frame(), *media_, pixel_step(settings_.resolution));
    draw(context, Way::marched);
}

void MarchTerms::add_shares(PassContext& context) {
    draw(context, Way::guide_only);
}

bool MarchTerms::alone() const {
    const std::vector<Term>& terms = media_->plan().terms(Solver::ray_marched);
    return terms.size() == 1 && terms.front().source == Term::Source::light;
}

void MarchTerms::spread(PassContext& context, const gpu::Texture& marched, const gpu::Buffer& list) {
    marched_ = &marched;
    list_ = &list;
    draw(context, Way::spread);
}

void MarchTerms::march_listed(PassContext& context, const gpu::Buffer& list) {
    list_ = &list;
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, list.name());
    draw(context, Way::listed);
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, 0);
}

void MarchTerms::draw(PassContext& context, Way way) {
    if (blue_noise_.name() == 0) blue_noise_ = make_blue_noise();
    way_ = way;
    skips_dark_ =
        settings_.shadow_mips && way != Way::guide_only && way != Way::spread && shadow_mips_.update(context.frame());
    MediaPrograms& programs = programs_.at(static_cast<size_t>(way));
    programs.begin();
    for (const Term& term : media_->plan().terms(Solver::ray_marched)) {
        if (term.source == Term::Source::light) {
            draw_light(context, term.light, static_cast<int>(term.medium));
        } else {
            draw_glow(context, term.source, static_cast<int>(term.medium));
            programs.begin();  // the lights' program is no longer in use
        }
    }
}

void MarchTerms::draw_or_dispatch(glm::ivec2 size) const {
    if (way_ == Way::spread) {
        dispatch_shares(size, pixel_step(settings_.resolution));
        return;
    }
    if (way_ != Way::listed) {
        gpu::draw_fullscreen();
        return;
    }
    glDispatchComputeIndirect(0);
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

void MarchTerms::bind_shares(const gpu::Program& program, PassContext& context, const gpu::Texture& marched,
                             const gpu::Buffer& list) const {
    bind_ray(program, context, media_->bounds(), pixel_step(settings_.resolution));
    program.image("marched", marched, 0, false);
    program.block("UnknownPixels", list);
}

void MarchTerms::dispatch_shares(glm::ivec2 size, int pixel_step) {
    // one invocation for each place between four marched pixels, whose middles are half a step from the frame's edge
    const glm::ivec2 groups = ((size - 1 - pixel_step / 2) / pixel_step + 2 + 7) / 8;
    glDispatchCompute(static_cast<GLuint>(groups.x), static_cast<GLuint>(groups.y), 1);
}

void MarchTerms::draw_glow(PassContext& context, Term::Source source, int medium) {
    const bool own = source == Term::Source::emission;
    const gpu::Program& program = context.frame().shaders.program(describe(way_, own ? "emission" : "environment"));
    program.use();
    if (!own) media_->environment().bind(program);
    bind_frame(program, context.frame());
    media_->bind(program, settings_.light_steps);
    bind(program, context);
    program.set("medium", medium);
    draw_or_dispatch(context.size());
}

void MarchTerms::draw_light(PassContext& context, size_t light, int medium) {
    Frame& frame = context.frame();
    const glm::ivec2 size = (context.size() + step() - 1) / step();
    const ScreenRectangle rectangle = light_rectangle(frame.scene.lights[light], frame.block.view_projection, size);
    if (rectangle.empty() && way_ != Way::spread) return;  // spread writes every pixel
    const PhaseKind phase = media_->media()[static_cast<size_t>(medium)].phase.kind;
    const bool ends = way_ == Way::spread && media_end(media_->bounds());
    const gpu::Program& program = programs_.at(static_cast<size_t>(way_))
                                      .of(phase, {skips_dark_ ? 1 : 0, ends ? 1 : 0})
                                      .use(frame, light, [&](const gpu::Program& fresh) {
                                          bind_light_source(fresh, context, *media_, settings_.light_steps);
                                          bind(fresh, context);
                                      });
    program.set("light_index", static_cast<unsigned>(light));
    program.set("medium", medium);
    glEnable(GL_SCISSOR_TEST);
    glScissor(rectangle.low.x, rectangle.low.y, rectangle.size.x, rectangle.size.y);
    draw_or_dispatch(context.size());
    glDisable(GL_SCISSOR_TEST);
}

int MarchTerms::step() const {
    return way_ == Way::marched ? pixel_step(settings_.resolution) : 1;
}

/// Twice as many where no mean over neighbours or frames follows.
int MarchTerms::steps() const {
    const bool alone = way_ == Way::listed || (settings_.temporal && history_.alone());
    return alone ? 2 * settings_.steps : settings_.steps;
}

void MarchTerms::bind(const gpu::Program& program, PassContext& context) const {
    program.set("least_transmittance", settings_.least_transmittance);
    if (way_ == Way::spread) {
        bind_shares(program, context, *marched_, *list_);
        program.image("media_in_scatter", context.texture("media_in_scatter"), 0, true);
        return;
    }
    bind_ray(program, context, media_->bounds(), step());
    if (way_ == Way::guide_only) {
        program.texture("media_shares", context.texture("media_shares"), {.filter = gpu::Filter::nearest});
        return;
    }
    if (way_ == Way::listed) {
        program.block("UnknownPixels", *list_);
        program.image("media_in_scatter", context.texture("media_in_scatter"), 0, true);
    }
    program.texture("blue_noise", blue_noise_,
                    {.filter = gpu::Filter::nearest, .wrap_u = gpu::Wrap::repeat, .wrap_v = gpu::Wrap::repeat});
    if (skips_dark_) shadow_mips_.bind(program);
    program.set("steps", steps());
    const bool moves = settings_.temporal && way_ == Way::marched;
    program.set("frame_offset", moves ? static_cast<float>(context.frame().scene.frame % 1024) * 0.61803399f : 0.0f);
    program.set("fixed_offset", settings_.jitter ? -1.0f : 0.5f);
}

bool MarchTerms::media_end(const Bounds& media) {
    const glm::vec3 size = media.size();
    return std::max(size.x, std::max(size.y, size.z)) < kFarthest;
}

void MarchTerms::bind_ray(const gpu::Program& program, PassContext& context, const Bounds& media, int pixel_step) {
    program.texture("scene_depth", context.texture("scene_depth"), {.filter = gpu::Filter::nearest});
    program.set("pixel_step", pixel_step);
    program.set("farthest", kFarthest);
    if (!media_end(media)) return;
    program.set("media_low", media.low);
    program.set("media_high", media.high);
}

}  // namespace tyndall::participating_media
