#include <algorithm>

#include "scene/components.h"
#include "scene/engine_extraction.h"

namespace tyndall {
namespace {

std::shared_ptr<const TextureAsset> gobo_texture(const ExtractContext& context, const std::string& name) {
    return name.empty() ? nullptr : context.assets.texture(name, TextureUse::colour);
}

Light light_at(const ExtractContext& context, LightKind kind, const glm::vec3& colour, float amount) {
    Light light;
    light.kind = kind;
    light.transform = rigid_transform(context.transform);
    light.intensity = colour * amount;
    light.entity = context.entity;
    return light;
}

ShadowRequest shadow_request(const ShadowComponent& shadow) {
    return {.enabled = shadow.enabled, .size = shadow.size};
}

ShadowRequest shadow_request(const CascadedShadowComponent& shadow) {
    return {
        .enabled = shadow.enabled, .size = shadow.size, .cascades = shadow.cascades, .distance_m = shadow.distance_m};
}

LightsRequest lights_request(const EnvironmentLightsComponent& lights) {
    return {.count = lights.count, .shadow = shadow_request(lights.shadow)};
}

void extract_directional(const ExtractContext& context, const DirectionalLightComponent& from, RenderScene& scene) {
    Light light = light_at(context, LightKind::directional, from.colour, from.illuminance_lux);
    light.angular_radius = 0.5f * glm::radians(from.angular_diameter_deg);
    light.gobo = gobo_texture(context, from.gobo);
    light.gobo_size_m = from.gobo_size_m;
    light.shadow = shadow_request(from.shadow);
    scene.lights.push_back(std::move(light));
}

void extract_spot(const ExtractContext& context, const SpotLightComponent& from, RenderScene& scene) {
    Light light = light_at(context, LightKind::spot, from.colour, from.intensity_cd);
    light.outer_angle = glm::radians(from.outer_angle_deg);
    light.inner_angle = std::min(glm::radians(from.inner_angle_deg), light.outer_angle);
    light.profile = from.profile;
    light.range_m = from.range_m;
    light.source_radius_m = from.source_radius_m;
    light.gobo = gobo_texture(context, from.gobo);
    light.shadow = shadow_request(from.shadow);
    scene.lights.push_back(std::move(light));
}

void extract_point(const ExtractContext& context, const PointLightComponent& from, RenderScene& scene) {
    Light light = light_at(context, LightKind::point, from.colour, from.intensity_cd);
    light.range_m = from.range_m;
    light.source_radius_m = from.source_radius_m;
    light.shadow = shadow_request(from.shadow);
    scene.lights.push_back(std::move(light));
}

void extract_probe(const ExtractContext& context, const LightProbeComponent& from, RenderScene& scene) {
    if (from.file.empty()) throw Error("a light probe needs a file");
    LightProbe probe;
    probe.image = context.assets.texture(from.file, TextureUse::probe);
    probe.intensity = from.intensity;
    probe.transform = rigid_transform(context.transform);
    if (from.extent_m != glm::vec3(0.0f)) probe.extent_m = from.extent_m;
    probe.blend_m = from.blend_m;
    probe.lights = lights_request(from.lights);
    probe.entity = context.entity;
    scene.probes.push_back(std::move(probe));
}

void extract_sky(const ExtractContext& context, const SkyComponent& from, RenderScene& scene) {
    if (!from.probe.empty()) scene.sky.image = context.assets.texture(from.probe, TextureUse::probe);
    scene.sky.radiance = scene.sky.image ? glm::vec3(from.intensity) : from.radiance_cd_m2 * from.intensity;
    scene.sky.rotation = glm::mat3(rigid_transform(context.transform));
    scene.sky.lights = lights_request(from.lights);
}

void extract_camera(const ExtractContext& context, const CameraComponent& from, RenderScene& scene) {
    Camera camera;
    camera.transform = rigid_transform(context.transform);
    camera.vertical_fov = glm::radians(from.vertical_fov_deg);
    camera.near_m = from.near_m;
    camera.ev100 = from.ev100;
    if (from.exposure > 0.0f) camera.exposure = from.exposure;
    camera.entity = context.entity;
    scene.cameras.push_back(camera);
}

}  // namespace

void add_light_extractors(Extractors& extractors) {
    add_extractor<DirectionalLightComponent>(extractors, extract_directional);
    add_extractor<SpotLightComponent>(extractors, extract_spot);
    add_extractor<PointLightComponent>(extractors, extract_point);
    add_extractor<LightProbeComponent>(extractors, extract_probe);
    add_extractor<SkyComponent>(extractors, extract_sky);
    add_extractor<CameraComponent>(extractors, extract_camera);
}

}  // namespace tyndall
