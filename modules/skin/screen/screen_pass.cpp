#include "screen/screen_pass.h"

#include <epoxy/gl.h>

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/frame.h"
#include "render/pixel_rectangle.h"
#include "seen_rectangle.h"

namespace tyndall::skin {
namespace {

/// Kernels kept between frames.
constexpr size_t kMostKernels = 32;
constexpr int kMostTaps = 63;
/// Kernels are made anew where pixels are larger or smaller by this share.
constexpr float kSamePixel = 0.01f;
/// Livermore 2012, figure 51, its weights made to sum to 1 per channel: what stays, and a Gaussian of this variance.
constexpr float kWideVariance_m2 = 6e-6f;
const glm::vec3 kWideShare{0.767f, 0.545f, 0.351f / (0.694f + 0.351f)};

bool on_screen(Technique technique) {
    return technique == Technique::two_gaussians || technique == Technique::separable || technique == Technique::disc;
}

/// The one Gaussian that two_gaussians blurs by; as wide as the published one where the profile is six_gaussians.
physics::DiffusionProfile wide_gaussian(const physics::DiffusionProfile& profile) {
    const float as_published = physics::six_gaussian_skin().mean_square().x;
    return {{{kWideVariance_m2 * profile.mean_square().x / as_published, glm::vec3(1.0f)}}};
}

}  // namespace

ScreenPass::ScreenPass(std::shared_ptr<SkinTables> tables, const SkinSettings& settings)
    : tables_(std::move(tables)), settings_(settings) {}

void ScreenPass::declare(PassDeclaration& declaration) {
    declaration.stage(Stage::diffusion)
        .reads("scene_depth", "where the skin is")
        .reads("gbuffer_surface", "which skin is seen, and its plane")
        .reads("gbuffer_base", "colour, of which some counts where light enters", true)
        .reads("skin_pixels", "the same where there is no such target")
        .writes("skin_light", {.format = gpu::Format::rgba32f}, "irradiance that enters skin, metres from the eye")
        .writes("skin_spread", {.format = gpu::Format::rgba32f}, "the same, spread along one direction")
        .updates("light_diffuse", "irradiance spread under the skin")
        .after("skin.transmission");
}

std::vector<ScreenPass::Group> ScreenPass::groups(PassContext& context) const {
    const Frame& frame = context.frame();
    std::vector<Group> groups;
    for (const Surface& surface : frame.scene.surfaces) {
        if (!surface.diffusion || !on_screen(technique_of(*surface.diffusion))) continue;
        const PixelRectangle pixels = pixels_of(surface.bounds, frame.block.view_projection, context.size());
        if (pixels.empty()) continue;
        const Technique technique = technique_of(*surface.diffusion);
        const auto same = [&](const Group& group) {
            return group.technique == technique && *group.profile == surface.diffusion->profile;
        };
        auto group = std::ranges::find_if(groups, same);
        if (group == groups.end()) {
            const auto& profiles = tables_->profiles();
            const auto number = std::ranges::find_if(
                profiles, [&](const physics::DiffusionProfile* p) { return *p == surface.diffusion->profile; });
            groups.push_back({technique, &surface.diffusion->profile, float(number - profiles.begin() + 1), pixels.low,
                              pixels.low + pixels.size, nearest_pixel_m(surface.bounds, frame),
                              far_depth(surface.bounds, frame), scatters_colour(surface)});
            continue;
        }
        group->low = glm::min(group->low, pixels.low);
        group->high = glm::max(group->high, pixels.low + pixels.size);
        group->far = std::min(group->far, far_depth(surface.bounds, frame));
        group->coloured = group->coloured || scatters_colour(surface);
        group->pixel_m = std::min(group->pixel_m, nearest_pixel_m(surface.bounds, frame));
    }
    return groups;
}

const ScreenPass::Kernel& ScreenPass::kernel_of(const Group& group) {
    const bool disc = group.technique == Technique::disc;
    const physics::DiffusionProfile profile =
        group.technique == Technique::two_gaussians ? wide_gaussian(*group.profile) : *group.profile;
    // closer up, where a kernel is many pixels wide, cells stay as many pixels
    const float pixels = reach(profile) / group.pixel_m;
    // one wide Gaussian is smooth: half of the taps do
    const bool smooth = group.technique == Technique::two_gaussians;
    const int taps = std::max(settings_.taps / 2, int(std::ceil(pixels / 2.0f)));
    const int a_side = std::clamp(smooth ? (taps + 1) / 2 : taps, 1, kMostTaps / 2);
    const int count = disc ? settings_.disc_taps : 1 + a_side;
    const auto same = [&](const Kernel& kernel) {
        return kernel.technique == group.technique && kernel.count == count &&
               std::abs(kernel.least_m - group.pixel_m) <= kSamePixel * group.pixel_m && kernel.profile == profile;
    };
    if (const auto found = std::ranges::find_if(kernels_, same); found != kernels_.end()) return *found;
    if (kernels_.size() >= kMostKernels) kernels_.erase(kernels_.begin());
    Kernel kernel{group.technique, profile, count, group.pixel_m, {}, {}};
    if (disc)
        for (const DiscTap& tap : disc_kernel(profile, count, group.pixel_m)) {
            kernel.taps.emplace_back(tap.weight, glm::length(tap.place));
            kernel.places.emplace_back(tap.place, 0.0f, 0.0f);
        }
    else
        kernel.taps = line_kernel(profile, count - 1, group.pixel_m).taps;
    return kernels_.emplace_back(std::move(kernel));
}

const gpu::Program& ScreenPass::begin(PassContext& context, gpu::ProgramDesc desc, bool coloured) const {
    Frame& frame = context.frame();
    const gpu::Texture* base = context.find_texture("gbuffer_base");
    if (coloured) desc.defines.emplace_back("COLOURED");
    if (coloured && base) desc.defines.emplace_back("BASE");
    const gpu::Program& program = frame.shaders.program(desc);
    program.use();
    bind_frame(program, frame);
    tables_->bind_surfaces(program, frame.scene);
    program.texture("gbuffer_surface", context.texture("gbuffer_surface"), {.filter = gpu::Filter::nearest});
    if (coloured && base)
        program.texture("gbuffer_base", *base, {.filter = gpu::Filter::nearest});
    else if (coloured)
        program.texture("skin_pixels", context.texture("skin_pixels"), {.filter = gpu::Filter::nearest});
    return program;
}

void ScreenPass::pack(PassContext& context, const std::vector<Group>& groups) {
    static constexpr std::string_view kTargets[] = {"skin_light", "scene_depth"};
    static constexpr std::string_view kSpread[] = {"skin_spread", "scene_depth"};
    glm::ivec2 low = groups.front().low, high = groups.front().high;
    float far = 1.0f;
    for (const Group& group : groups) {
        low = glm::min(low, group.low);
        high = glm::max(high, group.high);
        far = std::min(far, group.far);
    }
    const std::array<float, 4> nothing{};
    // taps beyond the silhouette must not find what another view had there
    context.bind_targets(kSpread, -1);
    glClearBufferfv(GL_COLOR, 0, nothing.data());
    context.bind_targets(kTargets, -1);
    glClearBufferfv(GL_COLOR, 0, nothing.data());
    const bool coloured = std::ranges::any_of(groups, &Group::coloured);
    const gpu::Program& program = begin(context, {.name = "skin.pack", .fragment = "skin/screen/pack.frag"}, coloured);
    for (const char* target : {"scene_depth", "light_diffuse"})
        program.texture(target, context.texture(target), {.filter = gpu::Filter::nearest});
    const Within within(low, high, far);
    gpu::draw_fullscreen();
}

void ScreenPass::gather(PassContext& context, const Group& group, const Kernel& kernel, int step) {
    const bool disc = group.technique == Technique::disc;
    const bool last = !disc && step == 1;
    const std::string_view targets[] = {last ? "light_diffuse" : "skin_spread", "scene_depth"};
    const gpu::ProgramDesc desc{
        .name = disc ? "skin.disc" : "skin.line",
        .fragment = "skin/screen/gather.frag",
        .defines = {fmt::format("TAPS {}", kernel.taps.size()), disc ? "DISC" : "LINE", last ? "LAST" : "FIRST"}};
    context.bind_targets(targets, -1);
    const gpu::Program& program = begin(context, desc, last && group.coloured);
    program.texture("from", context.texture(step == 0 ? "skin_light" : "skin_spread"),
                    {.filter = gpu::Filter::nearest});
    program.texture("skin_light", context.texture("skin_light"), {.filter = gpu::Filter::nearest});
    for (size_t i = 0; i < kernel.taps.size(); ++i) {
        program.set(fmt::format("taps[{}]", i), kernel.taps[i]);
        if (disc) program.set(fmt::format("places[{}]", i), kernel.places[i]);
    }
    const glm::vec3 spread = 0.5f * kernel.profile.mean_square();
    program.set("falloff", 0.5f / std::max({spread.x, spread.y, spread.z, 1e-12f}));
    program.set("profile", group.number);
    program.set("technique", float(group.technique));
    program.set("share", group.technique == Technique::two_gaussians ? kWideShare : glm::vec3(1.0f));
    const Within within(group.low, group.high, group.far);
    gpu::draw_fullscreen();
}

void ScreenPass::average(PassContext& context, const Group& group, const Kernel& kernel) {
    static constexpr std::string_view kTargets[] = {"light_diffuse", "scene_depth"};
    context.bind_targets(kTargets, -1);
    const gpu::Program& program =
        begin(context, {.name = "skin.average", .fragment = "skin/screen/average.frag"}, group.coloured);
    program.texture("from", context.texture("skin_spread"), {.filter = gpu::Filter::nearest});
    program.texture("skin_light", context.texture("skin_light"), {.filter = gpu::Filter::nearest});
    program.set("middle", glm::vec3(kernel.taps.front()));
    program.set("same", 2.0f * reach(kernel.profile));
    program.set("profile", group.number);
    program.set("technique", float(group.technique));
    const Within within(group.low, group.high, group.far);
    gpu::draw_fullscreen();
}

void ScreenPass::execute(PassContext& context) {
    if (!settings_.enabled) return;
    tables_->update(context.frame().scene);
    const std::vector<Group> seen = groups(context);
    if (seen.empty()) return;
    pack(context, seen);
    for (const Group& group : seen) {
        const Kernel& kernel = kernel_of(group);
        gather(context, group, kernel, 0);
        if (group.technique == Technique::disc)
            average(context, group, kernel);
        else
            gather(context, group, kernel, 1);
    }
}

}  // namespace tyndall::skin
