#include "geometry/thickness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>

#include "core/parallel.h"

namespace tyndall {
namespace {

/// Rays begin so far below the surface, over the body's size.
constexpr float kBelow = 1e-4f;
constexpr float kGoldenAngle = std::numbers::pi_v<float> * 0.76393202f;  // (3 - sqrt 5)

}  // namespace

InwardRays::InwardRays(const Mesh& mesh, int count)
    : triangles_(mesh),
      directions_(cosine_directions(count)),
      body_size_(glm::distance(mesh.bounds.low, mesh.bounds.high)) {}

float InwardRays::thickness(const glm::vec3& position, const glm::vec3& normal, float turn) const {
    const glm::mat3 inward = frame_about(-normal, turn);
    const float below = kBelow * body_size_;
    const glm::vec3 from = position - below * normal;
    float sum = 0.0f;
    for (const glm::vec3& d : directions_) {
        const auto hit = triangles_.cast(from, inward * d, body_size_);
        sum += d.z * (hit ? hit->distance : body_size_);
    }
    return below + sum / float(directions_.size());
}

namespace {

/// For each vertex a number that it shares with all in the same place with the same normal: UV seams split vertices.
std::vector<uint32_t> number_corners(const Mesh& mesh) {
    std::map<std::array<float, 6>, uint32_t> known;
    std::vector<uint32_t> numbers;
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3 &p = mesh.positions[i], &n = mesh.normals[i];
        numbers.push_back(known.try_emplace({p.x, p.y, p.z, n.x, n.y, n.z}, uint32_t(known.size())).first->second);
    }
    return numbers;
}

struct Corner {
    float thickness = 0.0f;
    float area = 0.0f;  ///< of the triangle
};

/// Of corner `c` of the mesh's indices: as seen from nearer to its vertex than to the others.
Corner corner_of(const Mesh& mesh, const InwardRays& rays, size_t c) {
    constexpr float kNear = 0.6f;
    glm::vec3 at(0.0f), normal(0.0f);
    std::array<glm::vec3, 3> p;
    for (size_t k = 0; k < 3; ++k) {
        const uint32_t vertex = mesh.indices[c - c % 3 + (c + k) % 3];
        const float weight = k == 0 ? kNear : 0.5f * (1.0f - kNear);
        p[k] = mesh.positions[vertex];
        at += weight * p[k];
        normal += weight * mesh.normals[vertex];
    }
    const float area = 0.5f * glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
    const float length = glm::length(normal);
    if (!(area > 0.0f) || !(length > 0.0f)) return {};
    return {rays.thickness(at, normal / length, kGoldenAngle * float(c % 1024)), area};
}

}  // namespace

std::vector<float> vertex_thicknesses(const Mesh& mesh) {
    constexpr size_t kAllRays = 600000;
    if (mesh.indices.empty() || mesh.normals.empty()) return {};
    const size_t corners = mesh.indices.size();
    const InwardRays rays(mesh, int(std::clamp<size_t>(kAllRays / corners, 6, 64)));
    std::vector<Corner> found(corners);
    parallel_for(0, corners, 256, [&](size_t first, size_t last) {
        for (size_t c = first; c < last; ++c) found[c] = corner_of(mesh, rays, c);
    });
    const std::vector<uint32_t> numbers = number_corners(mesh);
    std::vector<Corner> sums(mesh.positions.size());
    for (size_t c = 0; c < corners; ++c) {
        Corner& sum = sums[numbers[mesh.indices[c]]];
        sum.thickness += found[c].area * found[c].thickness;
        sum.area += found[c].area;
    }
    float whole = 0.0f;
    std::vector<float> result;
    for (const uint32_t number : numbers) {
        const Corner& sum = sums[number];
        whole += sum.area;
        result.push_back(sum.area > 0.0f ? sum.thickness / sum.area : 0.0f);
    }
    return whole > 0.0f ? result : std::vector<float>{};
}

}  // namespace tyndall
