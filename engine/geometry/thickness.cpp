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

/// Spread as the cosine to +Z is, evenly by a golden spiral.
std::vector<glm::vec3> spread_directions(int count) {
    std::vector<glm::vec3> directions;
    for (int i = 0; i < count; ++i) {
        const float share = (float(i) + 0.5f) / float(count), radius = std::sqrt(share);
        const float angle = float(i) * std::numbers::pi_v<float> * (3.0f - std::sqrt(5.0f));
        directions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), std::sqrt(1.0f - share));
    }
    return directions;
}

}  // namespace

InwardRays::InwardRays(const Mesh& mesh, int count)
    : triangles_(mesh),
      directions_(spread_directions(count)),
      body_size_(glm::distance(mesh.bounds.low, mesh.bounds.high)) {}

float InwardRays::thickness(const glm::vec3& position, const glm::vec3& normal, float turn) const {
    const glm::vec3 inward = -normal;
    glm::vec3 x =
        glm::normalize(glm::cross(inward, std::abs(inward.x) < 0.7f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0)));
    glm::vec3 y = glm::cross(inward, x);
    if (turn != 0.0f) {
        const glm::vec3 turned = std::cos(turn) * x + std::sin(turn) * y;
        y = glm::cross(inward, turned);
        x = turned;
    }
    const float below = kBelow * body_size_;
    const glm::vec3 from = position + below * inward;
    float sum = 0.0f;
    for (const glm::vec3& d : directions_) {
        const auto hit = triangles_.cast(from, d.x * x + d.y * y + d.z * inward, body_size_);
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
