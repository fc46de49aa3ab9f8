#pragma once
/// The border between what a light's shadow map says is lit and what is not, as a closed mesh.

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "render/shadow_views.h"

namespace tyndall::participating_media {

/// Triangles that are front faces as seen from the dark side.
struct ShadowMesh {
    std::vector<glm::vec3> positions;  ///< world, metres
    std::vector<uint32_t> indices;
};

/// How finely a shadow map becomes a mesh.
struct ShadowMeshDetail {
    int texels_per_quad = 1;    ///< of the finest triangles
    float tolerance_m = 0.01f;  ///< along the light; negative: all triangles as fine as they get
    bool operator==(const ShadowMeshDetail&) const = default;
};

/// How far along the view's axis a point lies, metres: from the light, or for directional lights from the map's near
/// plane.
[[nodiscard]] float axis_distance(const ShadowView& view, const glm::vec3& p);

/// The mesh of one shadow map: the surface at its depths, and
///  - perspective: the sides of the pyramid between the light and the surface, so that what is inside is lit;
///  - directional: sides and a lid behind it, so that what is inside is dark and all around is lit.
/// `depths` are the view's size^2 texels, reversed-Z, bottom row first; where they hold nothing, the surface lies
/// `reach` metres along the axis. The six views `of_cube` overlap by what filters look at: their meshes do not.
[[nodiscard]] ShadowMesh make_shadow_mesh(const ShadowView& view, std::span<const float> depths, float reach,
                                          const ShadowMeshDetail& detail, bool of_cube = false);

}  // namespace tyndall::participating_media
