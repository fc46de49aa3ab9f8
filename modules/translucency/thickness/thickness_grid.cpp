#include "thickness/thickness_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/parallel.h"
#include "geometry/surface_points.h"
#include "geometry/thickness.h"

namespace tyndall::translucency {
namespace {

constexpr int kLevels = 13;  ///< 2 to this power points
constexpr int kRays = 32;

/// Sums over the voxels' corners about each point; what no point is near takes the mean of its neighbours, twice.
class Splats {
 public:
    explicit Splats(glm::ivec3 size) : size_(size), sums_(count()), weights_(count()) {}
    void add(const glm::vec3& at, float value) {
        const glm::vec3 low = glm::floor(at - 0.5f), f = at - 0.5f - low;
        for (int i = 0; i < 8; ++i) {
            const glm::ivec3 step(i & 1, (i >> 1) & 1, i >> 2);
            const glm::vec3 share = glm::mix(1.0f - f, f, glm::vec3(step));
            const glm::ivec3 voxel = glm::clamp(glm::ivec3(low) + step, glm::ivec3(0), size_ - 1);
            sums_[index(voxel)] += share.x * share.y * share.z * value;
            weights_[index(voxel)] += share.x * share.y * share.z;
        }
    }
    void widen() {
        const std::vector<float> sums = sums_, weights = weights_;
        for (int z = 0; z < size_.z; ++z)
            for (int y = 0; y < size_.y; ++y)
                for (int x = 0; x < size_.x; ++x) widen({x, y, z}, sums, weights);
    }
    [[nodiscard]] std::vector<float> means() const {
        std::vector<float> means(sums_.size());
        for (size_t i = 0; i < means.size(); ++i) means[i] = weights_[i] > 0.0f ? sums_[i] / weights_[i] : 0.0f;
        return means;
    }

 private:
    [[nodiscard]] size_t count() const { return size_t(size_.x) * size_t(size_.y) * size_t(size_.z); }
    [[nodiscard]] size_t index(glm::ivec3 v) const {
        return (size_t(v.z) * size_t(size_.y) + size_t(v.y)) * size_t(size_.x) + size_t(v.x);
    }
    /// A little of the neighbours everywhere: it smooths, and fills what is empty.
    void widen(glm::ivec3 at, const std::vector<float>& sums, const std::vector<float>& weights) {
        constexpr float kShare = 0.1f;
        for (int axis = 0; axis < 3; ++axis)
            for (const int step : {-1, 1}) {
                glm::ivec3 other = at;
                other[axis] += step;
                if (other[axis] < 0 || other[axis] >= size_[axis]) continue;
                sums_[index(at)] += kShare * sums[index(other)];
                weights_[index(at)] += kShare * weights[index(other)];
            }
    }
    glm::ivec3 size_;
    std::vector<float> sums_, weights_;
};

}  // namespace

ThicknessGrid make_thickness_grid(const Mesh& mesh, int resolution) {
    const std::vector<SurfacePoint> points = sample_surface(mesh, kLevels);
    ThicknessGrid grid;
    if (points.empty()) return grid;
    const glm::vec3 extent = mesh.bounds.high - mesh.bounds.low;
    const float voxel = std::max({extent.x, extent.y, extent.z}) / float(resolution);
    const InwardRays rays(mesh, kRays);
    std::vector<float> found(points.size());
    parallel_for(0, points.size(), 256, [&](size_t first, size_t last) {
        for (size_t i = first; i < last; ++i) found[i] = rays.thickness(points[i].position, points[i].normal);
    });
    grid.box.low = mesh.bounds.low - voxel;
    grid.size = glm::ivec3(glm::ceil(extent / voxel)) + 2;
    grid.box.high = grid.box.low + voxel * glm::vec3(grid.size);
    Splats splats(grid.size);
    double sum = 0.0;
    for (size_t i = 0; i < points.size(); ++i) {
        splats.add((points[i].position - grid.box.low) / voxel, found[i]);
        sum += double(found[i]);
    }
    splats.widen();
    splats.widen();
    grid.thickness = splats.means();
    grid.mean = float(sum / double(points.size()));
    return grid;
}

}  // namespace tyndall::translucency
