#include "march/march_pass.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <array>

#include "render/frame.h"

namespace tyndall::participating_media {
namespace {

bool below_full(const MediaSettings& settings) {
    return settings.resolution != Resolution::full;
}

bool filters_apart(const MediaSettings& settings) {
    return settings.filter && below_full(settings);
}

/// What the filter reads.
std::string found_grainy(const MediaSettings& settings) {
    return settings.temporal ? "media_accumulated" : "media_marched";
}

/// What the gathering pass reads.
std::string found(const MediaSettings& settings) {
    return filters_apart(settings) ? "media_marched_filtered" : found_grainy(settings);
}

std::string media_end_define(const MediaBuffer& media) {
    return MarchTerms::media_end(media.bounds()) ? "MEDIA_END 1" : "MEDIA_END 0";
}

/// Pixels up to `radius` away are filtered together.
gpu::ProgramDesc filter(const MediaBuffer& media, int radius) {
    return {.name = "participating_media.filter",
            .fragment = "participating_media/march/filter.frag",
            .defines = {fmt::format("RADIUS {}", radius), media_end_define(media)}};
}

}  // namespace

TargetDesc marched_target(const MediaSettings& settings) {
    return {.format = gpu::Format::rgba32f, .scale = 1.0f / static_cast<float>(pixel_step(settings.resolution))};
}

void MarchPass::declare(PassDeclaration& declaration) {
    declaration.stage(Stage::media).reads("scene_depth", "where rays end");
    declaration.writes("media_marched", marched_target(settings_),
                       "single-scattered radiance between the eye and the surface, and its guide");
}

void MarchPass::execute(PassContext& context) {
    if (!media_->plan().uses(Solver::ray_marched)) return;
    context.bind_targets();
    constexpr std::array<float, 4> kNothing{};
    glClearBufferfv(GL_COLOR, 0, kNothing.data());
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    terms_->march(context);
    glDisable(GL_BLEND);
}

void FilterPass::declare(PassDeclaration& declaration) {
    declaration.stage(Stage::media);
    if (!filters_apart(settings_)) return;
    declaration.reads(found_grainy(settings_), "grainy")
        .reads("scene_depth", "where rays end")
        .writes("media_marched_filtered", marched_target(settings_), "the same without its grain");
}

void FilterPass::execute(PassContext& context) {
    if (!media_->plan().uses(Solver::ray_marched)) return;
    context.bind_targets();
    const gpu::Program& program = context.frame().shaders.program(filter(*media_, 1));
    program.use();
    bind_frame(program, context.frame());
    MarchTerms::bind_ray(program, context, media_->bounds(), pixel_step(settings_.resolution));
    program.texture("marched", context.texture(found_grainy(settings_)), {.filter = gpu::Filter::nearest});
    gpu::draw_fullscreen();
}

void GatherPass::declare(PassDeclaration& declaration) {
    declaration.stage(Stage::media)
        .reads("scene_depth", "where rays end")
        .reads(found(settings_), "what the march found")
        .writes("media_in_scatter", {.format = gpu::Format::rgba32f},
                "single-scattered radiance between the eye and the surface, and that distance");
    if (!below_full(settings_)) return;
    declaration.writes("media_shares", {.format = gpu::Format::rgba16f}, "what part of the guide there is");
}

void GatherPass::execute(PassContext& context) {
    static const gpu::ProgramDesc kNothing{.name = "participating_media.distance",
                                           .fragment = "participating_media/march/distance.frag"};
    const bool marched = media_->plan().uses(Solver::ray_marched);
    if (marched && below_full(settings_)) {
        upsample(context);
        return;
    }
    constexpr std::array<std::string_view, 1> kTargets{"media_in_scatter"};
    context.bind_targets(kTargets, -1);
    if (!marched) return draw(context, kNothing);
    gpu::ProgramDesc filtered = filter(*media_, settings_.filter ? 1 : 0);
    filtered.defines.emplace_back("AT_FULL_RESOLUTION");
    draw(context, filtered);
}

void GatherPass::draw(PassContext& context, const gpu::ProgramDesc& desc) {
    const gpu::Program& program = context.frame().shaders.program(desc);
    program.use();
    bind_frame(program, context.frame());
    MarchTerms::bind_ray(program, context, media_->bounds(), pixel_step(settings_.resolution));
    program.texture("marched", context.texture(found(settings_)), {.filter = gpu::Filter::nearest});
    gpu::draw_fullscreen();
}

void GatherPass::make_list(glm::ivec2 size) {
    constexpr std::array<unsigned, 4> kEmpty{0, 1, 1, 0};
    const size_t bytes = sizeof(kEmpty) + sizeof(unsigned) * static_cast<size_t>(size.x) * static_cast<size_t>(size.y);
    if (list_.size() != bytes) list_ = gpu::Buffer(bytes, nullptr, "participating_media.unknown_pixels");
    list_.update(0, sizeof(kEmpty), kEmpty.data());
}

void GatherPass::upsample(PassContext& context) {
    make_list(context.size());
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    if (terms_->alone())
        terms_->spread(context, context.texture(found(settings_)), list_);
    else
        add_shares(context);
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_COMMAND_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
    terms_->march_listed(context, list_);
    glMemoryBarrier(GL_FRAMEBUFFER_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

void GatherPass::add_shares(PassContext& context) {
    const gpu::ProgramDesc shares{.name = "participating_media.shares",
                                  .compute = "participating_media/march/shares.comp",
                                  .defines = {"GUIDE_ONLY", media_end_define(*media_)}};
    constexpr std::array<std::string_view, 1> kTargets{"media_in_scatter"};
    const gpu::Program& program = context.frame().shaders.program(shares);
    program.use();
    bind_frame(program, context.frame());
    terms_->bind_shares(program, context, context.texture(found(settings_)), list_);
    program.image("media_in_scatter", context.texture("media_in_scatter"), 0, true);
    program.image("media_shares", context.texture("media_shares"), 0, true);
    MarchTerms::dispatch_shares(context.size(), pixel_step(settings_.resolution));
    glMemoryBarrier(GL_FRAMEBUFFER_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
    // what is added leaves the alpha alone: a distance
    context.bind_targets(kTargets, -1);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE);
    terms_->add_shares(context);
    glDisable(GL_BLEND);
}

}  // namespace tyndall::participating_media
