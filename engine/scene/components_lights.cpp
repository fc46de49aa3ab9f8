#include "ecs/transform.h"
#include "scene/components.h"
#include "scene/scattering_components.h"

namespace tyndall {
namespace {

constexpr double kMostIntensity = 1e9;
constexpr int kMostEnvironmentLights = 128;
constexpr const char* kColour = "Colour; multiplies the intensity, so white leaves it as it is.";
constexpr const char* kLights = "Its diffuse light as directional lights; without this object by spherical harmonics.";
constexpr const char* kRange = "Where a smooth window ends the light; 0 = it goes on for ever, as real light does.";

}  // namespace

void describe(StructBuilder<ShadowComponent>& d) {
    d.doc("Shadows; a light without this object casts none.");
    d.field("enabled", &ShadowComponent::enabled, "Switches them; true when the object is written without it.");
    d.field("size", &ShadowComponent::size, "Texels on a side of the shadow map.").range(16, 8192);
}

void describe(StructBuilder<CascadedShadowComponent>& d) {
    using S = CascadedShadowComponent;
    d.doc("Shadows; a light without this object casts none.");
    d.field("enabled", &S::enabled, "Switches them; true when the object is written without it.");
    d.field("size", &S::size, "Texels on a side of each cascade.").range(16, 8192);
    d.field("cascades", &S::cascades, "Shadow maps, each for a farther part of the view.").range(1, 4);
    d.field("distance_m", &S::distance_m, "The last one ends here, from the camera.").unit("m").range(0.1, 1e5);
}

void describe(StructBuilder<EnvironmentLightsComponent>& d) {
    using L = EnvironmentLightsComponent;
    d.doc("Directional lights in place of light from all around.");
    d.field("count", &L::count, "How many; bright places get more of them. 0 = by spherical harmonics.")
        .range(0, kMostEnvironmentLights);
    d.field("shadow", &L::shadow, "The shadows of each; none without this object.");
}

void describe(StructBuilder<DirectionalLightComponent>& d) {
    using L = DirectionalLightComponent;
    d.doc("Light from far away, such as the sun's, along the entity's local -Z.");
    d.field("illuminance_lux", &L::illuminance_lux, "On a plane that faces it. Clear noon: 100000; full moon: 0.3.")
        .unit("lux")
        .range(0, kMostIntensity);
    d.field("colour", &L::colour, kColour).range(0, 1e3).colour();
    d.field("angular_diameter_deg", &L::angular_diameter_deg, "How large the source looks; softens shadows.")
        .unit("deg")
        .range(0, 90);
    d.field("gobo", &L::gobo, "A picture that colours the light, such as a window's glass.").asset("texture");
    d.field("gobo_size_m", &L::gobo_size_m, "Width and height of the gobo, centred on the entity.")
        .unit("m")
        .range(0.001, 1e5);
    d.field("shadow", &L::shadow, "Its shadows; none without this object.");
}

void describe(StructBuilder<SpotLightComponent>& d) {
    using L = SpotLightComponent;
    d.doc("Light from a point into a cone around the entity's local -Z.");
    d.field("intensity_cd", &L::intensity_cd, "Luminous intensity along the axis.").unit("cd").range(0, kMostIntensity);
    d.field("colour", &L::colour, kColour).range(0, 1e3).colour();
    d.field("inner_angle_deg", &L::inner_angle_deg,
            "Half angle of the cone of full intensity; never more than outer_angle_deg.")
        .unit("deg")
        .range(0, 89.9);
    d.field("outer_angle_deg", &L::outer_angle_deg, "Half angle at which the light ends.").unit("deg").range(0.1, 89.9);
    d.field("profile", &L::profile, "How it falls between the cones: as glTF says, or as Blender's smoothstep.",
            {"gltf", "smoothstep"});
    d.field("range_m", &L::range_m, kRange).unit("m").range(0, 1e6);
    d.field("source_radius_m", &L::source_radius_m, "Size of the source; softens shadows.").unit("m").range(0, 100);
    d.field("gobo", &L::gobo, "A picture that colours the light; it fills the outer cone's square.").asset("texture");
    d.field("shadow", &L::shadow, "Its shadows; none without this object.");
}

void describe(StructBuilder<PointLightComponent>& d) {
    using L = PointLightComponent;
    d.doc("Light from a point into all directions. A candle: about 1 cd; a 60 W bulb: about 65 cd.");
    d.field("intensity_cd", &L::intensity_cd, "Luminous intensity.").unit("cd").range(0, kMostIntensity);
    d.field("colour", &L::colour, kColour).range(0, 1e3).colour();
    d.field("range_m", &L::range_m, kRange).unit("m").range(0, 1e6);
    d.field("source_radius_m", &L::source_radius_m, "Size of the source; softens shadows.").unit("m").range(0, 100);
    d.field("shadow", &L::shadow, "Its shadows; none without this object.");
}

void describe(StructBuilder<LightProbeComponent>& d) {
    using L = LightProbeComponent;
    d.doc("Light from all around, seen from the entity, as an equirectangular picture.");
    d.field("file", &L::file, "An .exr or .hdr picture of radiance.").asset("probe");
    d.field("intensity", &L::intensity, "Multiplies the picture.").range(0, kMostIntensity);
    d.field("extent_m", &L::extent_m, "Half the size of the box that it lights; 0 = the whole scene.")
        .unit("m")
        .range(0, 1e6);
    d.field("blend_m", &L::blend_m, "Over this distance inside the box it gives way to the next probe.")
        .unit("m")
        .range(0, 1e6);
    d.field("lights", &L::lights, std::string(kLights) + " Of a probe without a box alone.");
}

void describe(StructBuilder<SkyComponent>& d) {
    using S = SkyComponent;
    d.doc("What is behind everything: a picture turned by the entity's rotation, or one radiance.");
    d.field("probe", &S::probe, "An equirectangular picture of radiance.").asset("probe");
    d.field("radiance_cd_m2", &S::radiance_cd_m2, "Without a picture: the radiance everywhere.")
        .unit("cd/m2")
        .range(0, kMostIntensity);
    d.field("intensity", &S::intensity, "Multiplies either.").range(0, kMostIntensity);
    d.field("lights", &S::lights, kLights);
}

void describe(StructBuilder<CameraComponent>& d) {
    using C = CameraComponent;
    d.doc("A camera that looks along the entity's local -Z.");
    d.field("vertical_fov_deg", &C::vertical_fov_deg, "Angle of view from bottom to top.").unit("deg").range(1, 170);
    d.field("ev100", &C::ev100, "Exposure value at ISO 100. Sunny day: 15; church inside: 5 to 8.").range(-20, 30);
    d.field("exposure", &C::exposure, "Factor from radiance to picture instead of ev100; 0 = ev100.").range(0, 1e9);
    d.field("near_m", &C::near_m, "Nothing nearer is seen.").unit("m").range(0.001, 100);
}

void describe(StructBuilder<CameraPathPoint>& d) {
    d.field("position", &CameraPathPoint::position, "Where the camera is, in the world.").unit("m");
    d.field("look_at", &CameraPathPoint::look_at, "What it looks at, in the world.").unit("m");
}

void describe(StructBuilder<CameraPathComponent>& d) {
    d.doc("A flight of the camera through points, at even speed.");
    d.field("duration_s", &CameraPathComponent::duration_s, "From the first point to the last.")
        .unit("s")
        .range(0.01, 1e5);
    d.field("loop", &CameraPathComponent::loop, "From the last point it goes on to the first.");
    d.field("points", &CameraPathComponent::points, "What it passes.");
}

void add_engine_components(ComponentRegistry& registry) {
    registry.add<Transform>();
    registry.add<WorldMatrix>();
    registry.add<GltfComponent>();
    registry.add<MeshComponent>();
    registry.add<MaterialComponent>();
    registry.add<InteriorComponent>();
    registry.add<ColliderComponent>();
    registry.add<DirectionalLightComponent>();
    registry.add<SpotLightComponent>();
    registry.add<PointLightComponent>();
    registry.add<LightProbeComponent>();
    registry.add<SkyComponent>();
    registry.add<CameraComponent>();
    registry.add<CameraPathComponent>();
    registry.add<TransientComponent>();
}

}  // namespace tyndall
