#pragma once
/// How the media that a light shines on lie in a map of it: what is needed of the scene to see their shadows. Needs no
/// GL.

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "geometry/bounds.h"
#include "scene/render_scene.h"

namespace tyndall::participating_media {

/// Whether light's way through it has no closed form (media.glsl's medium_uneven).
[[nodiscard]] bool is_uneven(const DensityField& density);

/// The boxes of uneven media.
struct UnevenMedia {
    std::vector<glm::vec3> corners;  ///< eight a box
    Bounds bounds;
    [[nodiscard]] bool empty() const { return corners.empty(); }
};
[[nodiscard]] UnevenMedia uneven_media(const std::vector<Medium>& media, const RenderScene& scene);

/// As in shaders/shadows/mapping.glsl.
enum class MapKind { parallel = 0, pyramid = 1, octahedron = 2 };

/// A light's map over all uneven media: each texel is a ray away from the light. The camera has no part in it, so it
/// keeps still. The outermost texels' rays meet no media, so that what lies beyond the map's border is read there.
struct ShadowFit {
    MapKind kind = MapKind::parallel;
    glm::mat4 map_from_world{1.0f};  ///< to u, v (times w) and, of parallel rays, the share of the depths
    glm::vec3 origin{0.0f};          ///< parallel: of the ray at u = v = 0, on the nearest plane; otherwise the light
    /// The ray at (u, v) begins at origin + u across + v up and goes along `base` when rays are parallel, and otherwise
    /// begins at the origin and goes along base + u across + v up, not of unit length.
    glm::vec3 base{0.0f}, across{0.0f}, up{0.0f};
    float near_m = 0.0f, far_m = 1.0f;  ///< metres along the rays between which the media lie

    bool operator==(const ShadowFit&) const = default;
};

/// The fit for a map of `size` texels on a side; none when the light reaches no medium.
[[nodiscard]] std::optional<ShadowFit> fit_shadow_map(const Light& light, const UnevenMedia& media, int size);

/// The boxes of all levels of the clipmap (shadows/extinction_clipmap.h), finest first. The last is that of all uneven
/// media; each before it is half as wide along each axis and lies as near to the camera as it can without leaving the
/// last. They move in steps of an eighth of their width, so voxels keep their places in the world.
[[nodiscard]] std::vector<Bounds> clipmap_boxes(const Bounds& media, const glm::vec3& camera, int levels, int voxels);

}  // namespace tyndall::participating_media
