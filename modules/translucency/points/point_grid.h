#pragma once
/// A cloud's points by where they are.

#include <algorithm>
#include <cstdint>
#include <glm/common.hpp>
#include <vector>

#include "geometry/bounds.h"
#include "points/point_cloud.h"

namespace tyndall::translucency {

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

/// The points that together stand for a place of the surface, by how near they are and how alike their normals.
[[nodiscard]] PointCloud::Vertex blended(const PointCloud& cloud, const PointGrid& grid, const glm::vec3& at,
                                         const glm::vec3& normal);

}  // namespace tyndall::translucency
