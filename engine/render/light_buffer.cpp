#include "render/light_buffer.h"

#include <algorithm>
#include <cmath>

#include "render/shadow_maps.h"

namespace tyndall {
namespace {

GpuLight gpu_light(const Light& light, int gobo) {
    const glm::mat4& m = light.transform;
    const bool spot = light.kind == LightKind::spot;
    const bool directional = light.kind == LightKind::directional;
    // A point light shines everywhere: a cone of 180 degrees.
    const float cos_outer = spot ? std::cos(light.outer_angle) : -1.0f;
    const float cos_inner = spot ? std::cos(std::min(light.inner_angle, light.outer_angle)) : -1.0f;
    const glm::vec2 half_size = directional ? 0.5f * light.gobo_size_m : glm::vec2(std::tan(light.outer_angle));
    GpuLight gpu{};
    gpu.position_range = glm::vec4(glm::vec3(m[3]), directional ? 0.0f : light.range_m);
    gpu.direction_kind = glm::vec4(-glm::vec3(m[2]), static_cast<float>(light.kind));
    gpu.right_cos_outer = glm::vec4(glm::vec3(m[0]), cos_outer);
    gpu.up_cos_inner = glm::vec4(glm::vec3(m[1]), cos_inner);
    gpu.intensity_profile = glm::vec4(light.intensity, static_cast<float>(light.profile));
    const int layer = light.kind == LightKind::point ? -1 : gobo;
    gpu.gobo = glm::vec4(static_cast<float>(layer), half_size, light.source_radius_m);
    gpu.shadow.y = light.of_environment ? 1.0f : 0.0f;
    return gpu;
}

}  // namespace

void LightBuffer::update(const RenderScene& scene, const ShadowMaps& shadow_maps, GpuScene& gpu_scene,
                         gpu::ShaderLibrary& shaders) {
    gobos_.update(scene, gpu_scene, shaders);
    lights_.clear();
    for (size_t i = 0; i < scene.lights.size(); ++i) {
        lights_.push_back(gpu_light(scene.lights[i], gobos_.layer_of(scene.lights[i].gobo.get())));
        shadow_maps.describe(i, lights_.back());
    }
    if (lights_.empty()) lights_.emplace_back();  // a block may not be empty
    const size_t bytes = lights_.size() * sizeof(GpuLight);
    if (buffer_.size() < bytes) buffer_ = gpu::Buffer(bytes, nullptr, "Lights");
    buffer_.update(0, bytes, lights_.data());
}

void LightBuffer::bind(const gpu::Program& program) const {
    program.block("Lights", buffer_);
    gobos_.bind(program);
}

void LightBuffer::bind_one(const gpu::Program& program, size_t light) const {
    program.block("Light", buffer_, light * sizeof(GpuLight), sizeof(GpuLight));
}

void bind_frame(const gpu::Program& program, Frame& frame) {
    program.block("FrameBlock", frame.frame_block);
    frame.lights.bind(program);
    frame.shadow_maps.bind(program);
}

void bind_light(const gpu::Program& program, const Frame& frame, size_t light) {
    frame.lights.bind_one(program, light);
}

}  // namespace tyndall
