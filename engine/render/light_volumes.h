#pragma once
/// Meshes that enclose what a light can reach.

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "scene/render_scene.h"

namespace tyndall {

/// A polyhedron around the unit sphere: three vertices a triangle, counter-clockwise from outside.
[[nodiscard]] std::vector<glm::vec3> sphere_volume();
/// A pyramid around the cone with its apex at the origin, along -Z to z = -1, of radius 1 there.
[[nodiscard]] std::vector<glm::vec3> cone_volume();

enum class LightVolumeKind { everywhere, sphere, cone };

/// Where a light's pixels can be.
struct LightVolume {
    LightVolumeKind kind = LightVolumeKind::everywhere;
    glm::mat4 world_from_volume{1.0f};
};

/// Of a light whose range, when it has none, ends with the surfaces of the scene.
[[nodiscard]] LightVolume light_volume(const Light& light, const Bounds& surfaces);

}  // namespace tyndall
