// Which points a vertex blends.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "body_space.h"
#include "core/parallel.h"
#include "points/point_cloud.h"
#include "points/point_grid.h"

namespace tyndall::translucency {
namespace {

/// Edges longer than this many spacings are cut.
constexpr float kLongestEdge = 1.5f;
/// How far apart opposite normals count, in spacings.
constexpr float kNormalWeight = 2.0f;

}  // namespace

/// The nearest points and one more, whose distance is where weights have fallen to nothing (Franke & Little's variant
/// of Shepard's weights: a point that comes or goes does so with weight 0).
PointCloud::Vertex blended(const PointCloud& cloud, const PointGrid& grid, const glm::vec3& at,
                           const glm::vec3& normal) {
    constexpr size_t kMost = PointCloud::kNeighbours + 1;
    std::array<std::pair<float, uint32_t>, kMost> best;
    const float weight = kNormalWeight * cloud.spacing;
    size_t count = 0;
    for (int reach = 1; count < kMost && reach <= 2 * grid.farthest(); reach *= 2) {
        count = 0;
        best.fill({std::numeric_limits<float>::max(), 0});
        grid.near(at, reach, [&](uint32_t i) {
            const glm::vec3 d = cloud.points[i].position - at;
            const glm::vec3 turned = 0.5f * weight * (cloud.points[i].normal - normal);
            const std::pair<float, uint32_t> one{glm::dot(d, d) + glm::dot(turned, turned), i};
            ++count;
            if (one >= best.back()) return;
            best.back() = one;
            for (size_t k = kMost - 1; k > 0 && best[k] < best[k - 1]; --k) std::swap(best[k], best[k - 1]);
        });
    }
    PointCloud::Vertex vertex{.position = at};
    const float farthest = std::sqrt(best.back().first);
    std::array<float, PointCloud::kNeighbours> weights{};
    float sum = 0.0f;
    for (size_t k = 0; k < PointCloud::kNeighbours; ++k) {
        const float d = std::max(std::sqrt(best[k].first), 1e-3f * cloud.spacing);
        const float share = std::max(farthest - d, 0.0f) / (farthest * d);
        weights[k] = share * share;
        sum += weights[k];
    }
    if (!(sum > 0.0f)) weights[0] = sum = 1.0f;
    for (size_t k = 0; k < PointCloud::kNeighbours; ++k) {
        vertex.points[k] = uint16_t(best[k].second);
        vertex.weights[k] = uint8_t(std::lround(255.0f * weights[k] / sum));
    }
    return vertex;
}

void blend_points(const Mesh& mesh, PointCloud& cloud) {
    Mesh drawn = cut_mesh(mesh, kLongestEdge * cloud.spacing);
    const PointGrid grid(cloud, mesh.bounds);
    cloud.indices = std::move(drawn.indices);
    cloud.vertices.resize(drawn.positions.size());
    parallel_for(0, cloud.vertices.size(), 1024, [&](size_t first, size_t last) {
        for (size_t i = first; i < last; ++i)
            cloud.vertices[i] = blended(cloud, grid, drawn.positions[i], drawn.normals[i]);
    });
}

}  // namespace tyndall::translucency
