#pragma once
/// Voxels near a surface that are told what its points know.

#include <algorithm>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "geometry/bounds.h"

namespace tyndall::translucency {

/// Even voxels about a mesh, with one to spare all around.
struct SurfaceGrid {
    Bounds box;
    glm::ivec3 size{0};
    float voxel = 0.0f;

    /// `resolution` voxels along the longest side.
    SurfaceGrid(const Bounds& mesh, int resolution) {
        const glm::vec3 extent = mesh.high - mesh.low;
        voxel = std::max({extent.x, extent.y, extent.z}) / float(resolution);
        size = glm::ivec3(glm::ceil(extent / voxel)) + 2;
        box.low = mesh.low - voxel;
        box.high = box.low + voxel * glm::vec3(size);
    }
    [[nodiscard]] size_t count() const { return size_t(size.x) * size_t(size.y) * size_t(size.z); }
    [[nodiscard]] size_t index(glm::ivec3 v) const {
        return (size_t(v.z) * size_t(size.y) + size_t(v.y)) * size_t(size.x) + size_t(v.x);
    }
    /// Calls `voxel(index, share)` for the eight about a place.
    template <class Voxel>
    void about(const glm::vec3& place, const Voxel& visit) const {
        const glm::vec3 at = (place - box.low) / voxel, low = glm::floor(at - 0.5f), f = at - 0.5f - low;
        for (int i = 0; i < 8; ++i) {
            const glm::ivec3 step(i & 1, (i >> 1) & 1, i >> 2);
            const glm::vec3 share = glm::mix(1.0f - f, f, glm::vec3(step));
            visit(index(glm::clamp(glm::ivec3(low) + step, glm::ivec3(0), size - 1)), share.x * share.y * share.z);
        }
    }
};

/// Sums over the voxels' corners about each point; what no point is near takes the mean of its neighbours.
template <class Value>
class Splats {
 public:
    explicit Splats(const SurfaceGrid& grid)
        : grid_(grid), sums_(grid.count(), Value(0.0f)), weights_(grid.count(), 0.0f) {}
    void add(const glm::vec3& place, const Value& value, float weight) {
        grid_.about(place, [&](size_t voxel, float share) {
            sums_[voxel] += share * weight * value;
            weights_[voxel] += share * weight;
        });
    }
    /// A little of the neighbours everywhere: it smooths, and fills what is empty.
    void widen() {
        const std::vector<Value> sums = sums_;
        const std::vector<float> weights = weights_;
        for (int z = 0; z < grid_.size.z; ++z)
            for (int y = 0; y < grid_.size.y; ++y)
                for (int x = 0; x < grid_.size.x; ++x) widen({x, y, z}, sums, weights);
    }
    [[nodiscard]] bool knows(size_t voxel) const { return weights_[voxel] > 0.0f; }
    [[nodiscard]] std::vector<Value> means() const {
        std::vector<Value> means(sums_.size(), Value(0.0f));
        for (size_t i = 0; i < means.size(); ++i)
            if (weights_[i] > 0.0f) means[i] = sums_[i] / weights_[i];
        return means;
    }

 private:
    void widen(glm::ivec3 at, const std::vector<Value>& sums, const std::vector<float>& weights) {
        constexpr float kShare = 0.1f;
        const size_t here = grid_.index(at);
        for (int axis = 0; axis < 3; ++axis)
            for (const int step : {-1, 1}) {
                glm::ivec3 other = at;
                other[axis] += step;
                if (other[axis] < 0 || other[axis] >= grid_.size[axis]) continue;
                sums_[here] += kShare * sums[grid_.index(other)];
                weights_[here] += kShare * weights[grid_.index(other)];
            }
    }
    const SurfaceGrid grid_;
    std::vector<Value> sums_;
    std::vector<float> weights_;
};

}  // namespace tyndall::translucency
