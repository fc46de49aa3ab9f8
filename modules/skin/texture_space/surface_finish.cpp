#include "texture_space/surface_finish.h"

#include <glm/gtc/matrix_access.hpp>

#include "render/light_state.h"
#include "render/texture_cache.h"

namespace tyndall::skin {
namespace {

bool known(const TextureSlot& slot) {
    return slot.texture && slot.uv_set == 0;
}

}  // namespace

float usable_pre_scatter(const Material& material, float wanted) {
    return known(material.base_colour_texture) ? wanted : 0.0f;
}

void bind_slot(const gpu::Program& program, GpuScene& scene, const std::string& name, const TextureSlot& slot) {
    program.set(name + "_share", known(slot) ? 1.0f : 0.0f);
    program.set(name + "_rows[0]", glm::vec3(glm::row(slot.uv_transform, 0)));
    program.set(name + "_rows[1]", glm::vec3(glm::row(slot.uv_transform, 1)));
    if (known(slot)) program.texture(name, scene.texture(*slot.texture), TextureCache::sampler(*slot.texture));
}

void SurfaceFinish::update(gpu::ShaderLibrary& shaders, GpuScene& scene, const Material& material, float pre_scatter,
                           const GpuAtlas& atlas, const glm::vec2& tile) {
    std::string state;
    append_state(state, material.id);
    append_state(state, pre_scatter);
    append_state(state, atlas.steps.name());
    if (state == made_from_) return;
    made_from_ = std::move(state);
    const gpu::TextureDesc& size = atlas.steps.desc();
    list_ = gpu::Texture({.format = gpu::Format::rgba32f, .width = size.width, .height = size.height}, "skin.finish");
    occlusion_ =
        gpu::Texture({.format = gpu::Format::r32f, .width = size.width, .height = size.height}, "skin.occlusion");
    const gpu::Program& program =
        shaders.program({.name = "skin.texture_space.finish", .compute = "skin/texture_space/finish.comp"});
    program.use();
    bind_list(program, "steps", atlas.steps);
    bind_list(program, "finish", list_);
    bind_list(program, "occlusion", occlusion_);
    program.set("list_size", unsigned(atlas.covered));
    program.set("gutter", float(kGutterTexels));
    program.set("uv_size", float(atlas.extent - 2 * kGutterTexels));
    program.set("tile", tile);
    program.set("base_colour", glm::vec3(material.base_colour));
    program.set("pre_scatter", pre_scatter);
    program.set("roughness", material.roughness);
    program.set("occlusion_strength", material.occlusion_strength);
    bind_slot(program, scene, "base_colour_map", material.base_colour_texture);
    bind_slot(program, scene, "metallic_roughness_map", material.metallic_roughness_texture);
    bind_slot(program, scene, "occlusion_map", material.occlusion_texture);
    dispatch_list(atlas.covered);
}

}  // namespace tyndall::skin
