#include "render/shadow_maps.h"

#include <epoxy/gl.h>

#include <algorithm>

#include "core/log.h"
#include "render/frame.h"
#include "render/gpu_scene.h"

namespace tyndall {
namespace {

GpuShadowView gpu_view(const ShadowView& view, int page_size) {
    const float page = static_cast<float>(page_size);
    const glm::vec2 corner = glm::vec2(view.corner) / page;
    const float size = static_cast<float>(view.size) / page;
    glm::mat4 page_from_clip(1.0f);
    page_from_clip[0][0] = page_from_clip[1][1] = 0.5f * size;
    page_from_clip[3] = glm::vec4(corner + 0.5f * size, 0.0f, 1.0f);
    const float half_texel = 0.5f / page;
    return {page_from_clip * view.clip_from_world, glm::vec4(corner + half_texel, corner + size - half_texel),
            glm::vec4(view.texel_m, static_cast<float>(view.page), view.fades ? 1.0f : 0.0f, 0.0f)};
}

}  // namespace

ShadowMaps::ShadowMaps(const ShadowLimits& limits) : limits_(limits) {}

void ShadowMaps::prepare(const RenderScene& scene, const Bounds& bounds, glm::vec2 tan_half_fov) {
    plan_ = plan_shadows(scene, bounds, tan_half_fov, limits_);
    if (plan_.reduced && !warned_)
        log::warning("shadow maps are smaller than asked for: at most {} texels on a side and {} MiB in all",
                     limits_.max_size, limits_.max_bytes >> 20);
    warned_ = plan_.reduced;
    make_pages();
}

void ShadowMaps::make_pages() {
    const gpu::TextureDesc& have = texture_.desc();
    const bool fits = texture_.name() != 0 && have.width == plan_.page_size && have.layers >= plan_.pages &&
                      have.layers <= 2 * plan_.pages;
    if (fits) return;
    pages_.clear();
    texture_ = gpu::Texture({.shape = gpu::Shape::array,
                             .format = gpu::Format::depth32f,
                             .width = plan_.page_size,
                             .height = plan_.page_size,
                             .layers = plan_.pages},
                            "shadow_maps");
    for (int page = 0; page < plan_.pages; ++page)
        pages_.emplace_back(std::span<const gpu::Framebuffer::Attachment>(),
                            gpu::Framebuffer::Attachment{&texture_, 0, page}, "shadow_maps");
    drawn_.clear();
}

void ShadowMaps::render(GpuScene& gpu_scene) {
    rendered_ = 0;
    drawn_.resize(plan_.views.size());
    for (size_t i = 0; i < plan_.views.size(); ++i) {
        const ShadowView& view = plan_.views[i];
        Drawn& drawn = drawn_[i];
        const uint64_t casters = gpu_scene.casters_hash(view.clip_from_world);
        if (drawn.valid && drawn.casters == casters && drawn.clip_from_world == view.clip_from_world &&
            drawn.size == view.size && drawn.page == view.page && drawn.corner == view.corner)
            continue;
        draw(view, gpu_scene);
        drawn = {view.clip_from_world, casters, view.size, view.page, view.corner, ++version_, true};
        ++rendered_;
    }
}

void ShadowMaps::draw(const ShadowView& view, GpuScene& gpu_scene) const {
    const gpu::Framebuffer& page = pages_[static_cast<size_t>(view.page)];
    page.bind();
    glViewport(view.corner.x, view.corner.y, view.size, view.size);
    glScissor(view.corner.x, view.corner.y, view.size, view.size);
    glEnable(GL_SCISSOR_TEST);
    glDepthMask(GL_TRUE);
    page.clear_depth();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    // What stands between a directional light and its map still casts shadows; a lamp's own glass does not.
    (view.perspective ? glDisable : glEnable)(GL_DEPTH_CLAMP);
    gpu_scene.draw_depth({.clip_from_world = view.clip_from_world, .eye = view.eye, .casters_only = true});
    glDisable(GL_DEPTH_CLAMP);
    glDisable(GL_SCISSOR_TEST);
}

void ShadowMaps::describe(size_t light, GpuLight& gpu_light) const {
    size_t count = 0;
    for (const ShadowView& view : plan_.views)
        if (view.light == light) gpu_light.views[count++] = gpu_view(view, plan_.page_size);
    gpu_light.shadow.x = static_cast<float>(count);
}

void ShadowMaps::bind(const gpu::Program& program) const {
    program.texture("shadow_map_depths", texture_, {.filter = gpu::Filter::linear, .compare = true});
}

void ShadowPass::declare(PassDeclaration& declaration) {
    const TargetDesc desc{
        .format = gpu::Format::depth32f, .shape = gpu::Shape::array, .own = [this] { return texture_; }};
    declaration.stage(Stage::shadow)
        .writes("shadow_maps", desc, "depth seen from each light, kept while nothing changes");
}

void ShadowPass::execute(PassContext& context) {
    Frame& frame = context.frame();
    frame.shadow_maps.render(frame.gpu_scene);
    texture_ = frame.shadow_maps.texture();
}

SeamProvider shadow_map_provider() {
    return {"shadow_maps",
            "render/shaders/shadow_maps.glsl",
            "shadow_maps_transmittance",
            {"shadow_maps"},
            [](const gpu::Program& program, PassContext& context) { context.frame().shadow_maps.bind(program); }};
}

}  // namespace tyndall
