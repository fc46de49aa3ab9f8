#pragma once
/// The engine's own authoring components beside Transform: what scene files are made of. Angles are degrees here, as
/// people write them; extraction turns everything into RenderScene.

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "ecs/description.h"
#include "scene/render_scene.h"

namespace tyndall {

// Shapes
// ---------------------------------------------------------------------------------------------------------------

/// A glTF file, placed by the entity's transform.
struct GltfComponent {
    static constexpr std::string_view kName = "gltf";
    std::string file;
    std::vector<std::string> cast_shadow_exclude;  ///< glob patterns over node names

    /// Nodes that give off more or less light than the file says.
    struct Glow {
        std::string nodes;       ///< glob pattern over node names
        glm::vec3 factor{1.0f};  ///< on the emission of their materials
        bool operator==(const Glow&) const = default;
    };
    std::vector<Glow> glow;  ///< the first that fits a node counts
};
void describe(StructBuilder<GltfComponent::Glow>& d);
void describe(StructBuilder<GltfComponent>& d);

/// Shapes that need no file. All fit the box from -1/2 to 1/2, so the transform's scale is their size in metres.
enum class Primitive { none, sphere, box, plane, cylinder };

/// A mesh from a file or a primitive shape; its material is the entity's MaterialComponent.
struct MeshComponent {
    static constexpr std::string_view kName = "mesh";
    std::string file;
    Primitive primitive = Primitive::none;
    int32_t tessellation = 32;
    int32_t subdivision_levels = 0;
    bool casts_shadow = true;
};
void describe(StructBuilder<MeshComponent>& d);

/// Material of the entity's mesh; on an entity with a glTF file it replaces all of the file's materials.
struct MaterialComponent {
    static constexpr std::string_view kName = "material";
    glm::vec3 base_colour{0.8f};
    float opacity = 1.0f;
    float metallic = 0.0f;
    float roughness = 0.5f;
    glm::vec3 emissive_cd_m2{0.0f};
    float normal_scale = 1.0f;
    float occlusion_strength = 1.0f;
    AlphaMode alpha_mode = AlphaMode::opaque;
    float alpha_cutoff = 0.5f;
    bool double_sided = false;
    float ior = 1.5f;
    float specular = 1.0f;
    glm::vec3 specular_colour{1.0f};
    float transmission = 0.0f;
    float thickness_m = 0.0f;
    glm::vec3 attenuation_colour{1.0f};
    float attenuation_distance_m = 0.0f;
    float diffuse_transmission = 0.0f;
    glm::vec3 diffuse_transmission_colour{1.0f};
    std::string base_colour_texture;
    std::string metallic_roughness_texture;
    std::string normal_texture;
    std::string occlusion_texture;
    std::string emissive_texture;
    std::string diffuse_transmission_texture;
    glm::vec2 uv_scale{1.0f};
    std::string shading_model = "standard";
    bool operator==(const MaterialComponent&) const = default;
};
void describe(StructBuilder<MaterialComponent>& d);

/// A walking camera collides with the meshes of this entity and of all below it.
struct ColliderComponent {
    static constexpr std::string_view kName = "collider";
};
void describe(StructBuilder<ColliderComponent>& d);

// Lights
// ---------------------------------------------------------------------------------------------------------------

/// Shadows of a point or spot light; writing the object switches them on.
struct ShadowComponent {
    bool enabled = false;
    int32_t size = 1024;
};
void describe(StructBuilder<ShadowComponent>& d);

/// Shadows of a directional light; writing the object switches them on.
struct CascadedShadowComponent {
    bool enabled = false;
    int32_t size = 1024;
    int32_t cascades = 3;
    float distance_m = 60.0f;
};
void describe(StructBuilder<CascadedShadowComponent>& d);

/// Directional lights in place of light from all around.
struct EnvironmentLightsComponent {
    int32_t count = 0;
    CascadedShadowComponent shadow;
};
void describe(StructBuilder<EnvironmentLightsComponent>& d);

struct DirectionalLightComponent {
    static constexpr std::string_view kName = "directional_light";
    float illuminance_lux = 50000.0f;
    glm::vec3 colour{1.0f};
    float angular_diameter_deg = 0.53f;
    std::string gobo;
    glm::vec2 gobo_size_m{1.0f};
    CascadedShadowComponent shadow;
};
void describe(StructBuilder<DirectionalLightComponent>& d);

struct SpotLightComponent {
    static constexpr std::string_view kName = "spot_light";
    float intensity_cd = 1000.0f;
    glm::vec3 colour{1.0f};
    float inner_angle_deg = 0.0f;
    float outer_angle_deg = 45.0f;
    SpotProfile profile = SpotProfile::gltf;
    float range_m = 0.0f;
    float source_radius_m = 0.0f;
    std::string gobo;
    ShadowComponent shadow;
};
void describe(StructBuilder<SpotLightComponent>& d);

struct PointLightComponent {
    static constexpr std::string_view kName = "point_light";
    float intensity_cd = 100.0f;
    glm::vec3 colour{1.0f};
    float range_m = 0.0f;
    float source_radius_m = 0.0f;
    ShadowComponent shadow;
};
void describe(StructBuilder<PointLightComponent>& d);

struct LightProbeComponent {
    static constexpr std::string_view kName = "light_probe";
    std::string file;
    float intensity = 1.0f;
    glm::vec3 extent_m{0.0f};  ///< half extents; 0 = the whole scene
    float blend_m = 1.0f;
    EnvironmentLightsComponent lights;
};
void describe(StructBuilder<LightProbeComponent>& d);

struct SkyComponent {
    static constexpr std::string_view kName = "sky";
    std::string probe;
    glm::vec3 radiance_cd_m2{0.0f};
    float intensity = 1.0f;
    EnvironmentLightsComponent lights;
};
void describe(StructBuilder<SkyComponent>& d);

// Cameras
// --------------------------------------------------------------------------------------------------------------

struct CameraComponent {
    static constexpr std::string_view kName = "camera";
    float vertical_fov_deg = 50.0f;
    float ev100 = 10.0f;
    float exposure = 0.0f;  ///< 0 = from ev100
    float near_m = 0.1f;
};
void describe(StructBuilder<CameraComponent>& d);

/// Where a path's camera is and what it looks at, in the world, in metres.
struct CameraPathPoint {
    glm::vec3 position{0.0f};
    glm::vec3 look_at{0.0f, 0.0f, -1.0f};
};
void describe(StructBuilder<CameraPathPoint>& d);

struct CameraPathComponent {
    static constexpr std::string_view kName = "camera_path";
    float duration_s = 30.0f;
    bool loop = false;
    std::vector<CameraPathPoint> points;
};
void describe(StructBuilder<CameraPathComponent>& d);

/// The rigid camera transform on a path at a time in seconds: a centripetal Catmull-Rom spline through the points
/// (Yuksel et al. 2011) at even speed along its length. A twentieth of the way of the looked-at point counts as well,
/// so that turning on the spot takes time. Before the start and after the end it stands there, or goes around when it
/// loops. Identity without points.
[[nodiscard]] glm::mat4 camera_path_transform(const CameraPathComponent& path, float time_s);

// Files
// ----------------------------------------------------------------------------------------------------------------

/// Marks entities that scene files do not keep, with all below them: what a running game or editor makes.
struct TransientComponent {
    static constexpr std::string_view kName = "transient";
};
void describe(StructBuilder<TransientComponent>& d);

/// Registers Transform, WorldMatrix and everything above. register_engine_components (scene/extraction.h) calls it.
void add_engine_components(ComponentRegistry& registry);

}  // namespace tyndall
