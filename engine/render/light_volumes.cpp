#include "render/light_volumes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace tyndall {
namespace {

constexpr int kConeSides = 16;
/// Wider spots are drawn as spheres: the cone's base would be larger than the sphere.
constexpr float kWidestCone = 1.1f;

std::vector<glm::vec3> icosahedron() {
    const float t = 0.5f * (1.0f + std::sqrt(5.0f));
    const std::array<glm::vec3, 12> v{{{-1, t, 0},
                                       {1, t, 0},
                                       {-1, -t, 0},
                                       {1, -t, 0},
                                       {0, -1, t},
                                       {0, 1, t},
                                       {0, -1, -t},
                                       {0, 1, -t},
                                       {t, 0, -1},
                                       {t, 0, 1},
                                       {-t, 0, -1},
                                       {-t, 0, 1}}};
    constexpr std::array<int, 60> kFaces{0, 11, 5,  0, 5,  1, 0, 1, 7, 0, 7,  10, 0, 10, 11, 1, 5, 9, 5, 11,
                                         4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3,  9,  4, 3,  4,  2, 3, 2, 6, 3,
                                         6, 8,  3,  8, 9,  4, 9, 5, 2, 4, 11, 6,  2, 10, 8,  6, 7, 9, 8, 1};
    std::vector<glm::vec3> triangles;
    for (const int index : kFaces) triangles.push_back(glm::normalize(v[size_t(index)]));
    return triangles;
}

std::vector<glm::vec3> subdivided(const std::vector<glm::vec3>& triangles) {
    std::vector<glm::vec3> finer;
    for (size_t i = 0; i < triangles.size(); i += 3) {
        const glm::vec3 a = triangles[i];
        const glm::vec3 b = triangles[i + 1];
        const glm::vec3 c = triangles[i + 2];
        const glm::vec3 ab = glm::normalize(a + b);
        const glm::vec3 bc = glm::normalize(b + c);
        const glm::vec3 ca = glm::normalize(c + a);
        for (const glm::vec3& v : {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca}) finer.push_back(v);
    }
    return finer;
}

/// Distance from the origin of the nearest face's plane.
float inner_radius(const std::vector<glm::vec3>& triangles) {
    float radius = std::numeric_limits<float>::max();
    for (size_t i = 0; i < triangles.size(); i += 3) {
        const glm::vec3 normal =
            glm::normalize(glm::cross(triangles[i + 1] - triangles[i], triangles[i + 2] - triangles[i]));
        radius = std::min(radius, glm::dot(normal, triangles[i]));
    }
    return radius;
}

/// Distance to the farthest corner.
float reach(const Bounds& box, const glm::vec3& from) {
    return glm::length(glm::max(glm::abs(box.low - from), glm::abs(box.high - from)));
}

}  // namespace

std::vector<glm::vec3> sphere_volume() {
    std::vector<glm::vec3> triangles = subdivided(icosahedron());
    const float scale = 1.0f / inner_radius(triangles);
    for (glm::vec3& vertex : triangles) vertex *= scale;
    return triangles;
}

std::vector<glm::vec3> cone_volume() {
    constexpr float kStep = 6.2831853f / float(kConeSides);
    const float radius = 1.0f / std::cos(0.5f * kStep);
    std::vector<glm::vec3> triangles;
    for (int i = 0; i < kConeSides; ++i) {
        const glm::vec3 a(radius * std::cos(kStep * float(i)), radius * std::sin(kStep * float(i)), -1.0f);
        const glm::vec3 b(radius * std::cos(kStep * float(i + 1)), radius * std::sin(kStep * float(i + 1)), -1.0f);
        for (const glm::vec3& v : {glm::vec3(0.0f), a, b, glm::vec3(0.0f, 0.0f, -1.0f), b, a}) triangles.push_back(v);
    }
    return triangles;
}

LightVolume light_volume(const Light& light, const Bounds& surfaces) {
    if (light.kind == LightKind::directional) return {};
    const glm::vec3 position(light.transform[3]);
    if (surfaces.empty()) return {LightVolumeKind::sphere, glm::mat4(0.0f)};
    const float far = 1.001f * reach(surfaces, position);
    const float range = light.range_m > 0.0f ? std::min(light.range_m, far) : far;
    const bool cone = light.kind == LightKind::spot && light.outer_angle < kWidestCone;
    const float radius = cone ? range * std::tan(light.outer_angle) : range;
    const glm::vec3 size(radius, radius, range);
    LightVolume volume{cone ? LightVolumeKind::cone : LightVolumeKind::sphere, light.transform};
    for (int i = 0; i < 3; ++i) volume.world_from_volume[i] *= size[i];
    return volume;
}

}  // namespace tyndall
