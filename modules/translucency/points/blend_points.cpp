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

namespace tyndall::translucency {
namespace {

/// Edges longer than this many spacings are cut.
constexpr float kLongestEdge = 1.5f;
/// How far apart opposite normals count, in spacings.
constexpr float kNormalWeight = 2.0f;

/// Points by the cells of a grid, as sorted runs.
class PointGrid {
 public:
    PointGrid(const PointCloud& cloud, const Bounds& bounds) : low_(bounds.low) {
        cell_ = 2.0f * cloud.spacing;
        const glm::vec3 size = bounds.size();
        while ((size.x / cell_ + 2) * (size.y / cell_ + 2) * (size.z / cell_ + 2) > 4e6f) cell_ *= 1.5f;
        size_ = glm::ivec3(size / cell_) + 1;
        begins_.assign(size_t(size_.x) * size_t(size_.y) * size_t(size_.z) + 1, 0);
        for (const SurfacePoint& point : cloud.points) ++begins_[index(cell_of(point.position)) + 1];
        for (size_t i = 1; i < begins_.size(); ++i) begins_[i] += begins_[i - 1];
        order_.resize(cloud.points.size());
        std::vector<uint32_t> next(begins_.begin(), begins_.end() - 1);
        for (uint32_t i = 0; i < cloud.points.size(); ++i) order_[next[index(cell_of(cloud.points[i].position))]++] = i;
    }

    /// Calls `found(point)` for all within `reach` cells around a place.
    template <class Found>
    void near(const glm::vec3& at, int reach, const Found& found) const {
        const glm::ivec3 centre = cell_of(at);
        const glm::ivec3 low = glm::max(centre - reach, glm::ivec3(0));
        const glm::ivec3 high = glm::min(centre + reach, size_ - 1);
        for (int z = low.z; z <= high.z; ++z)
            for (int y = low.y; y <= high.y; ++y)
                for (int x = low.x; x <= high.x; ++x) {
                    const size_t cell = index({x, y, z});
                    for (uint32_t i = begins_[cell]; i < begins_[cell + 1]; ++i) found(order_[i]);
                }
    }
    [[nodiscard]] int farthest() const { return std::max({size_.x, size_.y, size_.z}); }

 private:
    [[nodiscard]] glm::ivec3 cell_of(const glm::vec3& p) const {
        return glm::clamp(glm::ivec3((p - low_) / cell_), glm::ivec3(0), size_ - 1);
    }
    [[nodiscard]] size_t index(const glm::ivec3& cell) const {
        return (size_t(cell.z) * size_t(size_.y) + size_t(cell.y)) * size_t(size_.x) + size_t(cell.x);
    }

    glm::vec3 low_;
    float cell_ = 1.0f;
    glm::ivec3 size_{1};
    std::vector<uint32_t> begins_, order_;
};

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

}  // namespace

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
