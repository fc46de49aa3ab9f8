#include "scene/environment.h"

#include <algorithm>

namespace tyndall {
namespace {

constexpr int kSmallWidth = 256;

/// A directional light from a unit direction toward it.
Light directional(const glm::vec3& to_light, const glm::vec3& illuminance) {
    Light light;
    light.kind = LightKind::directional;
    glm::vec3 right, up;
    physics::orthonormal_basis(to_light, right, up);
    light.transform = glm::mat4(glm::vec4(right, 0.0f), glm::vec4(up, 0.0f), glm::vec4(to_light, 0.0f),
                                glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
    light.intensity = illuminance;
    light.of_environment = true;
    return light;
}

}  // namespace

Environment environment_of(const RenderScene& scene) {
    for (const LightProbe& probe : scene.probes)
        if (!probe.extent_m && probe.image && !probe.image->image.empty())
            return {probe.image, glm::vec3(probe.intensity), glm::mat3(probe.transform), probe.lights, probe.entity};
    const Sky& sky = scene.sky;
    const bool image = sky.image && !sky.image->image.empty();
    return {image ? sky.image : nullptr, sky.radiance, sky.rotation, sky.lights, {}};
}

Image small_environment(const TextureAsset& asset) {
    Image image = with_channels(to_float(asset.image), 3);
    if (image.width <= kSmallWidth) return image;
    return resize(image, kSmallWidth, kSmallWidth / 2);
}

std::span<const glm::vec3> pixels_of(const Image& image) {
    return {reinterpret_cast<const glm::vec3*>(image.floats().data()), image.value_count() / 3};
}

void LightsOfEnvironment::sample(const Environment& environment) {
    const uint64_t image = environment.image ? environment.image->id : 0;
    if (image == image_ && environment.lights.count == count_) return;
    image_ = image;
    count_ = environment.lights.count;
    if (!environment.image) {
        constexpr int kHeight = 64;  // rows: the same from everywhere
        const std::vector<glm::vec3> white(size_t(2 * kHeight * kHeight), glm::vec3(1.0f));
        lights_ = physics::lights_of_equirect(white, 2 * kHeight, kHeight, count_);
        return;
    }
    const Image small = small_environment(*environment.image);
    lights_ = physics::lights_of_equirect(pixels_of(small), small.width, small.height, count_);
}

void LightsOfEnvironment::add_to(RenderScene& scene) {
    const Environment environment = environment_of(scene);
    if (environment.lights.count <= 0 || environment.radiance == glm::vec3(0.0f)) return;
    sample(environment);
    for (const physics::DistantLight& from : lights_) {
        Light light =
            directional(environment.world_from_image * from.direction, environment.radiance * from.illuminance);
        light.shadow = environment.lights.shadow;
        light.entity = environment.entity;
        scene.lights.push_back(std::move(light));
    }
}

}  // namespace tyndall
