#include "render/light_probes.h"

#include <epoxy/gl.h>

#include <algorithm>

#include "physics/probe.h"
#include "render/frame.h"
#include "render/gpu_scene.h"
#include "render/seams.h"
#include "scene/environment.h"

namespace tyndall {
namespace {

constexpr int kMapSize = 128;  ///< texels a side of the sharpest map
constexpr int kMapMips = 5;    ///< roughness 0, 1/4 .. 1; the last is 8 texels a side

physics::Sh9 constant_harmonics() {
    physics::Sh9 harmonics{};
    harmonics.c[0] = glm::vec4(glm::vec3(1.0f / 0.282094792f), 0.0f);  // radiance 1 everywhere
    return harmonics;
}

void bind_sky(const gpu::Program& program, Frame& frame) {
    const Sky& sky = frame.scene.sky;
    program.set("sky_scale", sky.radiance);
    program.set("sky_has_image", sky.image ? 1 : 0);
    program.set("sky_image_from_world", glm::transpose(sky.rotation));
    if (sky.image)
        program.texture("sky_image", frame.gpu_scene.texture(*sky.image),
                        {.filter = gpu::Filter::linear, .wrap_u = gpu::Wrap::repeat});
}

}  // namespace

void LightProbes::provide(Seams& seams) {
    seams.add(Seam::indirect_light, {.name = "light_probes",
                                     .include = "render/shaders/light_probes.glsl",
                                     .function = "light_probes_indirect",
                                     .bind = [this](const gpu::Program& program, PassContext&) { bind(program); }});
    seams.add(Seam::sky,
              {.name = "sky",
               .include = "render/shaders/environment_sky.glsl",
               .function = "environment_sky",
               .bind = [](const gpu::Program& program, PassContext& context) { bind_sky(program, context.frame()); }});
}

void LightProbes::update(const RenderScene& scene) {
    for (auto& [id, filtered] : images_) filtered.used = false;
    records_.clear();
    for (const LightProbe& probe : scene.probes)
        if (records_.size() + 1 < kMaxProbes) add(probe);
    add(scene.sky);
    if (block_.size() == 0) block_ = gpu::Buffer(kMaxProbes * sizeof(Record), nullptr, "Probes");
    if (!records_.empty()) block_.update(0, records_.size() * sizeof(Record), records_.data());
}

void LightProbes::add(const LightProbe& probe) {
    if (!probe.image || probe.image->image.empty()) return;
    const Filtered& light = filtered(*probe.image);
    const glm::vec4 box = probe.extent_m ? glm::vec4(*probe.extent_m, std::max(probe.blend_m, 1e-4f)) : glm::vec4(0.0f);
    const bool by_lights = !probe.extent_m && probe.lights.count > 0;
    records_.push_back({glm::inverse(probe.transform), box, glm::vec4(glm::vec3(probe.intensity), float(light.layer)),
                        by_lights ? physics::Sh9{} : light.harmonics});
}

void LightProbes::add(const Sky& sky) {
    if (sky.radiance == glm::vec3(0.0f)) return;
    const bool by_lights = sky.lights.count > 0;
    if (!sky.image || sky.image->image.empty()) {
        records_.push_back({glm::mat4(1.0f), glm::vec4(0.0f), glm::vec4(sky.radiance, -1.0f),
                            by_lights ? physics::Sh9{} : constant_harmonics()});
        return;
    }
    const Filtered& light = filtered(*sky.image);
    records_.push_back({glm::mat4(glm::transpose(sky.rotation)), glm::vec4(0.0f),
                        glm::vec4(sky.radiance, float(light.layer)), by_lights ? physics::Sh9{} : light.harmonics});
}

const LightProbes::Filtered& LightProbes::filtered(const TextureAsset& asset) {
    const auto found = images_.find(asset.id);
    if (found != images_.end()) {
        found->second.used = true;
        return found->second;
    }
    const Image source = small_environment(asset);
    Filtered light;
    light.layer = free_layer();
    light.harmonics = physics::project_equirect(pixels_of(source), source.width, source.height);
    light.used = true;
    prefilter(source, light.layer);
    return images_[asset.id] = light;
}

/// A layer that no image of this frame holds; the maps grow when there is none.
int LightProbes::free_layer() {
    for (auto it = images_.begin(); it != images_.end(); ++it) {
        if (it->second.used) continue;
        const int layer = it->second.layer;
        images_.erase(it);
        return layer;
    }
    const int count = int(images_.size());
    if (maps_.name() == 0 || count >= maps_.desc().layers) {
        gpu::Texture larger({.shape = gpu::Shape::array,
                             .format = gpu::Format::rgba32f,
                             .width = kMapSize,
                             .height = kMapSize,
                             .layers = count + 1,
                             .mips = kMapMips},
                            "probe_maps");
        for (int mip = 0; mip < kMapMips && count > 0; ++mip)
            glCopyImageSubData(maps_.name(), GL_TEXTURE_2D_ARRAY, mip, 0, 0, 0, larger.name(), GL_TEXTURE_2D_ARRAY, mip,
                               0, 0, 0, kMapSize >> mip, kMapSize >> mip, count);
        maps_ = std::move(larger);
    }
    return count;
}

void LightProbes::prefilter(const Image& small, int layer) {
    static const gpu::ProgramDesc kDesc{.name = "probe_prefilter", .compute = "render/shaders/probe_prefilter.comp"};
    gpu::Texture source({.format = gpu::Format::rgba32f, .width = small.width, .height = small.height, .mips = 0},
                        "probe_source");
    source.upload(0, 0, with_channels(small, 4).pixels.data());
    source.generate_mips();
    const gpu::Program& program = shaders_.program(kDesc);
    program.use();
    program.texture("source", source, {.filter = gpu::Filter::trilinear, .wrap_u = gpu::Wrap::repeat});
    program.set("layer", layer);
    for (int mip = 0; mip < kMapMips; ++mip) {
        program.image("map", maps_, mip, true);
        program.set("roughness", float(mip) / float(kMapMips - 1));
        program.set("texels", kMapSize >> mip);
        const auto groups = GLuint((kMapSize >> mip) / 8);
        glDispatchCompute(groups, groups, 1);
    }
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void LightProbes::bind(const gpu::Program& program) const {
    program.block("Probes", block_);
    program.set("probe_count", int(records_.size()));
    if (maps_.name() != 0) program.texture("probe_maps", maps_, {.filter = gpu::Filter::trilinear});
}

}  // namespace tyndall
