#include "texture_space/metric.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace tyndall::skin {
namespace {

struct WeighedMetric {
    Metric sum;
    float weight = 0.0f;
};

/// Of a triangle with sides `a`, `b` in texels that are `p`, `q` in metres; all zero without an area in texels.
Metric metric_of(const glm::vec2& a, const glm::vec2& b, const glm::vec3& p, const glm::vec3& q) {
    const float area = a.x * b.y - a.y * b.x;
    if (std::abs(area) < 1e-9f) return {};
    const glm::vec3 u = (p * b.y - q * a.y) / area, v = (q * a.x - p * b.x) / area;
    return {glm::dot(u, u), glm::dot(u, v), glm::dot(v, v)};
}

void add(WeighedMetric& sum, const Metric& metric, float weight) {
    sum.sum.uu += weight * metric.uu;
    sum.sum.uv += weight * metric.uv;
    sum.sum.vv += weight * metric.vv;
    sum.weight += weight;
}

/// In the map, radians.
float angle_at(const Mesh& mesh, const uint32_t* corner, int i) {
    const glm::vec2 a = mesh.uv0[corner[(i + 1) % 3]] - mesh.uv0[corner[i]];
    const glm::vec2 b = mesh.uv0[corner[(i + 2) % 3]] - mesh.uv0[corner[i]];
    return std::abs(std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b)));
}

/// Sums for each point of the charts, over the triangles around.
std::vector<WeighedMetric> sums_of(const Mesh& mesh, const Charts& charts, int size, const glm::mat3& shape) {
    std::vector<WeighedMetric> sums(mesh.positions.size());
    for (size_t first = 0; first < mesh.indices.size(); first += 3) {
        const uint32_t* corner = &mesh.indices[first];
        const auto side = [&](int i) { return float(size) * (mesh.uv0[corner[i]] - mesh.uv0[corner[0]]); };
        const auto length = [&](int i) { return shape * (mesh.positions[corner[i]] - mesh.positions[corner[0]]); };
        const Metric metric = metric_of(side(1), side(2), length(1), length(2));
        if (metric.uu <= 0.0f) continue;
        for (int i = 0; i < 3; ++i) add(sums[charts.points[corner[i]]], metric, angle_at(mesh, corner, i));
    }
    return sums;
}

}  // namespace

std::vector<Metric> vertex_metrics(const Mesh& mesh, const Charts& charts, int size, const glm::mat3& shape) {
    const std::vector<WeighedMetric> sums = sums_of(mesh, charts, size, shape);
    std::vector<Metric> metrics(sums.size());
    for (size_t vertex = 0; vertex < sums.size(); ++vertex) {
        const WeighedMetric& sum = sums[charts.points[vertex]];
        const float scale = 1.0f / std::max(sum.weight, 1e-20f);
        metrics[vertex] = {scale * sum.sum.uu, scale * sum.sum.uv, scale * sum.sum.vv};
    }
    return metrics;
}

Metric mix(const Metric& a, const Metric& b, float share) {
    return {std::lerp(a.uu, b.uu, share), std::lerp(a.uv, b.uv, share), std::lerp(a.vv, b.vv, share)};
}

TexelSteps steps_of(const Metric& metric) {
    // the covariance of a round Gaussian in texels is the metric's inverse: a step along u alone and one across it
    const float uu = std::max(metric.uu, 1e-20f);
    const float determinant = std::max(metric.determinant(), 1e-6f * uu * metric.vv + 1e-30f);
    return {1.0f / std::sqrt(uu), -metric.uv / uu, std::sqrt(uu / determinant)};
}

}  // namespace tyndall::skin
