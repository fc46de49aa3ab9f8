#pragma once
/// The physical scene: what every solver reads (the two render paths, the modules' passes, the reference path tracer).
///
/// Plain structs in SI and photometric units, made from the World each frame by extractors, owned by nobody's
/// technique. World space: metres, right-handed, +Y up. Cameras and lights look along their local -Z. Radiance is
/// luminance-like: photometric (cd/m2) per channel of the scene-linear working space, since lights are given in cd and
/// lux.

#include <array>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ecs/world.h"
#include "geometry/mesh.h"
#include "image/image.h"
#include "physics/diffusion_profile.h"
#include "physics/profile_corrections.h"
#include "physics/slab_transmittance.h"
#include "scene/scattering.h"

namespace tyndall {

/// A number for a mesh, texture or material that no other in the process has: never 0, never given twice. Thread-safe.
[[nodiscard]] uint64_t new_asset_id();

/// A triangle mesh that is loaded once and shared. `id` is unique in the process and changes when the content does.
struct MeshAsset {
    uint64_t id = 0;
    std::string name;
    Mesh mesh;
};

enum class TextureFilter { nearest, linear, trilinear };
enum class TextureWrap { repeat, mirror, clamp };

/// An image ready for the GPU and the path tracer, shared. `id` as for MeshAsset.
struct TextureAsset {
    uint64_t id = 0;
    std::string name;
    Image image;                ///< u8 or f32, 1..4 channels, top row first; f32 colours are in the working space
    bool srgb_encoded = false;  ///< u8 colours that the sampler decodes with the sRGB curve into the working space
    TextureFilter filter = TextureFilter::trilinear;
    TextureWrap wrap_u = TextureWrap::repeat;
    TextureWrap wrap_v = TextureWrap::repeat;
};

/// A texture as a material uses it.
struct TextureSlot {
    std::shared_ptr<const TextureAsset> texture;  ///< null = the factor alone
    int uv_set = 0;                               ///< 0 or 1
    glm::mat3 uv_transform{1.0f};                 ///< KHR_texture_transform
};

enum class AlphaMode { opaque, mask, blend };

/// glTF 2.0 metallic-roughness with the extensions that the engine keeps.
struct Material {
    uint64_t id = 0;  ///< unique in the process; changes when the content does
    std::string name;
    std::string shading_model = "standard";  ///< provider of the shading-model seam
    glm::vec4 shading_parameters{0.0f};      ///< what that model makes of them
    glm::vec4 base_colour{1.0f};
    float metallic = 0.0f;
    float roughness = 1.0f;  ///< perceptual; GGX alpha = roughness^2
    float normal_scale = 1.0f;
    float occlusion_strength = 1.0f;
    glm::vec3 emissive{0.0f};  ///< cd/m2
    AlphaMode alpha_mode = AlphaMode::opaque;
    float alpha_cutoff = 0.5f;
    bool double_sided = false;
    float ior = 1.5f;
    float specular = 1.0f;  ///< KHR_materials_specular
    glm::vec3 specular_colour{1.0f};
    float transmission = 0.0f;  ///< KHR_materials_transmission, kept for refraction
    float thickness_m = 0.0f;   ///< KHR_materials_volume
    glm::vec3 attenuation_colour{1.0f};
    float attenuation_distance_m = 0.0f;  ///< 0 = infinite
    /// KHR_materials_diffuse_transmission: share of the diffuse light that goes through a thin surface instead of back,
    /// and its colour there.
    float diffuse_transmission = 0.0f;
    glm::vec3 diffuse_transmission_colour{1.0f};
    TextureSlot base_colour_texture, metallic_roughness_texture, normal_texture, occlusion_texture, emissive_texture;
    TextureSlot specular_texture, specular_colour_texture, transmission_texture, thickness_texture;
    TextureSlot diffuse_transmission_texture;         ///< its alpha counts
    TextureSlot diffuse_transmission_colour_texture;  ///< its colour counts
    /// Of what is painted over an interior (in the boundary's material alone): the share of the surface that it covers,
    /// and its colour. Light meets it under the boundary's mirror, from outside and from inside.
    float paint_cover = 0.0f;
    glm::vec3 paint_colour{1.0f};
    TextureSlot paint_texture;  ///< alpha times the cover, colour times the colour
};

/// What is inside a closed mesh, behind a dielectric boundary. A surface that has one is that boundary: where the
/// inside scatters, its material is made from the interior and has for its base what a half-space returns of diffuse
/// light. Solvers that know interiors do not draw the base. Coefficients are of the world's metres.
struct ScatteringInterior {
    glm::vec3 sigma_s_per_m{0.0f};
    glm::vec3 sigma_a_per_m{0.0f};
    glm::vec3 emission_cd_m2_per_m{0.0f};  ///< radiance given off per metre
    PhaseFunction phase;
    DensityField density;            ///< multiplies the three above
    float eta = 1.3f;                ///< index of refraction; 1 = index-matched: light passes the boundary unbent
    float roughness = 0.0f;          ///< of the boundary, perceptual; 0 = smooth
    int priority = 0;                ///< where interiors overlap, the highest is there and the others are not
    std::string technique = "auto";  ///< what the scene asks to render it with in real time, by a module's names
};

/// How thick a body is below its surface, for light that comes through it.
struct SurfaceThickness {
    TextureSlot map;              ///< first channel; without it `vertices` say it
    float map_m = 0.0f;           ///< metres of the world that 1 of the map stands for
    std::vector<float> vertices;  ///< the mesh's; metres over the cube root of the transform's volume
    bool all_lights = false;      ///< of lights with shadow maps as well, which may know it better
};

/// Light that enters the surface spreads under it and leaves beside (skin): what is thick and even compared with how
/// far light gets. The material's base colour is what comes back of diffuse light in all. Solvers that do not know it
/// have light leave where it enters.
struct SurfaceDiffusion {
    physics::DiffusionProfile profile;  ///< metres of the world
    float pre_scatter = 0.5f;   ///< base colour to this power counts where light enters, the rest where it leaves
    float transmission = 1.0f;  ///< share of what comes through thin parts that is shown
    /// Of light that enters one side of a thin part, what leaves the other, to be multiplied by the base colour; null =
    /// the profile's own guess (DiffusionProfile::through).
    std::shared_ptr<const physics::SlabTransmittance> through;
    physics::ProfileCorrections corrections;            ///< metres of the world
    std::shared_ptr<const SurfaceThickness> thickness;  ///< null = shadow maps alone say it
    float detail_m = 0.001f;                            ///< wavelength of what the normal map adds
    std::string technique;  ///< what the scene asks to render it with in real time, by a module's names
};

/// A mesh placed in the world.
struct Surface {
    std::shared_ptr<const MeshAsset> mesh;
    std::shared_ptr<const Material> material;
    glm::mat4 transform{1.0f};
    glm::mat4 previous_transform{1.0f};
    Bounds bounds;  ///< world space
    bool casts_shadow = true;
    bool collides = false;  ///< a walking viewer collides with it
    std::optional<ScatteringInterior> interior;
    /// Null = light leaves where it enters. Where there is an interior as well, that is the truth and this what real
    /// time takes for it.
    std::shared_ptr<const SurfaceDiffusion> diffusion;
    Entity entity;
};

/// How a light wants to be shadowed.
struct ShadowRequest {
    bool enabled = false;
    int size = 1024;        ///< texels on a side, per layer
    int cascades = 3;       ///< directional only, 1..4
    float distance_m = 60;  ///< directional only: cascades reach this far from the camera
};

enum class LightKind : uint32_t { point = 0, spot = 1, directional = 2 };
/// How a spot's intensity falls between its inner and outer cone (physics/units.glsl).
enum class SpotProfile : uint32_t { gltf = 0, smoothstep = 1 };

struct Light {
    LightKind kind = LightKind::point;
    glm::mat4 transform{1.0f};    ///< rigid: columns right, up, back (-travel), position
    glm::vec3 intensity{0.0f};    ///< colour times candela (point, spot) or lux (directional)
    float inner_angle = 0.0f;     ///< spot: half angle in radians at which the falloff starts
    float outer_angle = 0.7854f;  ///< spot: half angle in radians at which it ends
    SpotProfile profile = SpotProfile::gltf;
    float range_m = 0.0f;          ///< where a smooth window ends it; 0 = none: physically unbounded
    float angular_radius = 0.0f;   ///< directional: half the source's angular diameter, radians
    float source_radius_m = 0.0f;  ///< point, spot: size of the emitter, for soft shadows
    std::shared_ptr<const TextureAsset>
        gobo;                     ///< transmittance; spot: over the outer cone's square; directional: over gobo_size_m
    glm::vec2 gobo_size_m{1.0f};  ///< directional: rectangle centred on the light's origin in its local XY plane
    ShadowRequest shadow;
    /// Stands for a part of the environment (scene/environment.h), whose image has its mirror image: it makes no
    /// highlights. Solvers that light by the image itself leave it out.
    bool of_environment = false;
    Entity entity;
};

/// `whole_scene` is the bounding box of all surfaces, lights with a place, and the camera: fog without an end would let
/// no sunlight in.
/// `layer` is that box between two heights; `ellipsoid` is the largest in the unit box. What fills a mesh or is made of
/// particles is a box with a mask (ProductDensity).
enum class MediumShape : uint32_t { whole_scene, box, ellipsoid, layer };

/// A participating medium in the air: overlapping media add, and there is none of it inside a ScatteringInterior.
struct Medium {
    MediumShape shape = MediumShape::box;
    glm::mat4 transform{1.0f};                      ///< box, ellipsoid: the unit box [-1/2, 1/2]^3 to the world
    float layer_low_m = 0.0f, layer_high_m = 0.0f;  ///< layer: from this height to that
    glm::vec3 sigma_s_per_m{0.0f};
    glm::vec3 sigma_a_per_m{0.0f};
    glm::vec3 emission_cd_m2_per_m{0.0f};  ///< radiance given off per metre
    PhaseFunction phase;
    DensityField density;         ///< multiplies the three coefficients
    std::string solver = "auto";  ///< what the scene asks to render it with in real time, by the module's names
    /// Adds black-body radiance times sigma_a to the emission (Kirchhoff's law), by the temperature at each place.
    std::optional<TemperatureField> temperature;
    /// Multiplies the light that is scattered and not what is lost: 1 is physical, anything else an artist's choice.
    float scatter_factor = 1.0f;
    Entity entity;
};

/// How light from all around wants to be turned into directional lights; 0 = not.
struct LightsRequest {
    int count = 0;  ///< at most so many
    ShadowRequest shadow;
};

/// Light from all around, as an equirectangular image: direction d, u = 0.5 + atan2(d.x, -d.z) / 2 pi, v = acos(d.y) /
/// pi from the top.
struct LightProbe {
    std::shared_ptr<const TextureAsset> image;  ///< f32, radiance in the working space
    float intensity = 1.0f;
    glm::mat4 transform{1.0f};  ///< placement: turns the image, and centres the box
    std::optional<glm::vec3>
        extent_m;          ///< half extents of the box it lights and reflects (parallax); none = the whole scene
    float blend_m = 1.0f;  ///< over this distance inside the box it fades to the next probe
    LightsRequest lights;  ///< without a box: its diffuse light comes from RenderScene::lights
    Entity entity;
};

/// What lies behind everything.
struct Sky {
    std::shared_ptr<const TextureAsset> image;  ///< equirectangular as LightProbe; null = `radiance` alone
    glm::vec3 radiance{0.0f};                   ///< cd/m2; multiplies the image when there is one
    glm::mat3 rotation{1.0f};
    LightsRequest lights;  ///< its diffuse light comes from RenderScene::lights
};

struct Camera {
    glm::mat4 transform{1.0f};      ///< rigid: columns right, up, back, position
    float vertical_fov = 0.9f;      ///< radians
    float near_m = 0.1f;            ///< reversed-Z, infinite far plane
    float ev100 = 0.0f;             ///< exposure = 1 / (1.2 * 2^EV100)
    std::optional<float> exposure;  ///< overrides ev100 with a plain factor (reference pictures: 1)
    Entity entity;
};

/// One frame's worth of world.
struct RenderScene {
    Camera camera;                ///< the one that is looked through
    std::vector<Camera> cameras;  ///< all of the scene; their entities' names choose
    Sky sky;
    std::vector<Surface> surfaces;
    std::vector<Light> lights;
    std::vector<Medium> media;
    std::vector<LightProbe> probes;  ///< boxed ones first, smallest first
    double time_s = 0.0;
    uint64_t frame = 0;
    bool camera_cut = false;  ///< history is dropped
    /// Forgets what extraction makes and keeps the lists' memory; time, frame and cut stay.
    void clear();
};

/// Placement of a medium's unit box [-1/2, 1/2]^3 in the world; made of the whole scene's bounds for
/// MediumShape::whole_scene and layer. Without a volume where there is nothing of the medium.
[[nodiscard]] glm::mat4 medium_box(const Medium& medium, const RenderScene& scene);

}  // namespace tyndall
