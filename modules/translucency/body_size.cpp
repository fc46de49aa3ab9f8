#include "body_size.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "geometry/surface_points.h"

namespace tyndall::translucency {
namespace {

/// The vectors of a closed surface's area add up to nothing.
constexpr double kOpenShare = 0.05;
/// 2 to this power points of the surface, of which so many look at all others.
constexpr int kLevels = 13;
constexpr size_t kLooking = 256;
constexpr float kFlat = 2.0f;
/// The first ring's part of that.
constexpr float kFirst = 0.1f;

std::vector<SurfacePoint> points_of(const Mesh& mesh, const glm::mat3& world_from_local) {
    Mesh world;
    world.indices = mesh.indices;
    for (const glm::vec3& position : mesh.positions) world.positions.push_back(world_from_local * position);
    world.bounds = bounds_of(world.positions);
    return sample_surface(world, kLevels);
}

}  // namespace

/// By the divergence theorem about the mesh's middle.
float body_radius(const Mesh& mesh, const glm::mat3& world_from_local) {
    const glm::dmat3 world(world_from_local);
    const glm::dvec3 middle(mesh.bounds.centre());
    const auto corner = [&](size_t i) { return world * (glm::dvec3(mesh.positions[mesh.indices[i]]) - middle); };
    double six = 0.0, area = 0.0;
    glm::dvec3 open(0.0);
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const glm::dvec3 a = corner(i), b = corner(i + 1), c = corner(i + 2);
        six += glm::dot(a, glm::cross(b, c));
        open += glm::cross(b - a, c - a);
        area += glm::length(glm::cross(b - a, c - a));
    }
    if (!(area > 0.0) || glm::length(open) >= kOpenShare * area) return 0.0f;
    if (glm::determinant(world) < 0.0) six = -six;
    return float(std::max(0.0, six / area));  // 3 (six / 6) over area / 2
}

SurfaceDensity::SurfaceDensity(const Mesh& mesh, const glm::mat3& world_from_local) {
    const std::vector<SurfacePoint> points = points_of(mesh, world_from_local);
    if (points.empty()) return;
    Bounds bounds;
    float area = 0.0f;
    for (const SurfacePoint& point : points) {
        bounds.merge({point.position, point.position});
        area += point.area;
    }
    // Nearer than a few points lie from one another, the side that a point is on is as flat ground; another side
    // counts.
    const float flat = kFlat * std::sqrt(area / float(points.size()));
    const float last = std::max(glm::distance(bounds.low, bounds.high), 2.0f * flat), first = kFirst * flat;
    const float step = std::log(last / first) / float(kRings - 1);
    for (size_t i = 1; i <= kRings; ++i) ends_[i] = first * std::exp(step * float(i - 1));
    for (size_t at = 0; at < points.size(); at += points.size() / kLooking)
        for (const SurfacePoint& other : points) {
            const float apart = glm::distance(points[at].position, other.position);
            if (apart < flat && glm::dot(points[at].normal, other.normal) > 0.0f) continue;
            const auto ring = size_t(std::max(1.0f + std::log(apart / first) / step, 0.0f));
            density_[std::min(ring, kRings - 1)] += other.area / float(kLooking);
        }
    for (size_t i = 0; i < kRings; ++i) {
        const auto disc = [](float r) { return std::numbers::pi_v<float> * r * r; };
        const float known = std::clamp(flat, ends_[i], ends_[i + 1]);  // up to here this side has not been counted
        density_[i] += disc(known) - disc(ends_[i]);
        density_[i] /= disc(ends_[i + 1]) - disc(ends_[i]);
    }
}

glm::vec3 SurfaceDensity::sent_out(const RadialKernel& kernel) const {
    if (!(ends_[kRings] > 0.0f)) return glm::vec3(1.0f);
    glm::vec3 sum(0.0f), before(0.0f);
    for (size_t i = 0; i < kRings; ++i) {
        const glm::vec3 within = kernel.share_within(ends_[i + 1]);
        sum += density_[i] * (within - before);
        before = within;
    }
    return sum;
}

bool BodyShape::update(const glm::mat3& world_from_local) {
    const glm::mat3 metric = glm::transpose(world_from_local) * world_from_local;
    const glm::mat3 change = metric - metric_;
    const auto size = [](const glm::mat3& m) { return glm::length(m[0]) + glm::length(m[1]) + glm::length(m[2]); };
    if (size(change) <= 2e-3f * size(metric)) return false;
    metric_ = metric;
    return true;
}

bool BodyRadius::update(const Mesh& mesh, const glm::mat3& world_from_local) {
    if (!shape_.update(world_from_local)) return false;
    radius = body_radius(mesh, world_from_local);
    return true;
}

bool BodySize::update(const Mesh& mesh, const glm::mat3& world_from_local) {
    if (!shape_.update(world_from_local)) return false;
    radius = body_radius(mesh, world_from_local);
    surface = SurfaceDensity(mesh, world_from_local);
    return true;
}

}  // namespace tyndall::translucency
