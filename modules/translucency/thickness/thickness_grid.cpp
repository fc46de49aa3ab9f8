#include "thickness/thickness_grid.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <numbers>

#include "core/parallel.h"
#include "geometry/surface_points.h"

namespace tyndall::translucency {
namespace {

constexpr int kLevels = 13;  ///< 2 to this power points
constexpr int kRays = 32;
/// Rays begin so far below the surface, over the body's size.
constexpr float kBelow = 1e-4f;

/// The mesh's triangles for ray casts.
class Caster {
 public:
    explicit Caster(const Mesh& mesh)
        : device_(rtcNewDevice(nullptr), &rtcReleaseDevice), scene_(rtcNewScene(device_.get()), &rtcReleaseScene) {
        const std::unique_ptr<RTCGeometryTy, decltype(&rtcReleaseGeometry)> geometry(
            rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE), &rtcReleaseGeometry);
        auto* positions = static_cast<float*>(rtcSetNewGeometryBuffer(
            geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), mesh.positions.size()));
        auto* indices = static_cast<uint32_t*>(rtcSetNewGeometryBuffer(
            geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(uint32_t), mesh.triangle_count()));
        for (size_t i = 0; i < mesh.positions.size(); ++i)
            for (int c = 0; c < 3; ++c) positions[3 * i + size_t(c)] = mesh.positions[i][c];
        std::copy_n(mesh.indices.begin(), 3 * mesh.triangle_count(), indices);
        rtcCommitGeometry(geometry.get());
        rtcAttachGeometry(scene_.get(), geometry.get());
        rtcCommitScene(scene_.get());
    }
    /// To the first triangle, at most `farthest`.
    [[nodiscard]] float distance(const glm::vec3& from, const glm::vec3& direction, float farthest) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRayHit hit{};
        hit.ray = {from.x, from.y, from.z, 0.0f, direction.x, direction.y, direction.z, 0.0f, farthest, ~0u, 0, 0};
        hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene_.get(), &context, &hit);
        return hit.ray.tfar;
    }

 private:
    std::unique_ptr<RTCDeviceTy, decltype(&rtcReleaseDevice)> device_;
    std::unique_ptr<RTCSceneTy, decltype(&rtcReleaseScene)> scene_;
};

/// Spread as the cosine to +Z is, evenly by a golden spiral.
std::array<glm::vec3, kRays> spread_directions() {
    std::array<glm::vec3, kRays> directions;
    for (int i = 0; i < kRays; ++i) {
        const float share = (float(i) + 0.5f) / kRays, radius = std::sqrt(share);
        const float angle = float(i) * std::numbers::pi_v<float> * (3.0f - std::sqrt(5.0f));
        directions[size_t(i)] = {radius * std::cos(angle), radius * std::sin(angle), std::sqrt(1.0f - share)};
    }
    return directions;
}

float thickness_at(const SurfacePoint& point, const Caster& caster, float body_size) {
    static const std::array<glm::vec3, kRays> kDirections = spread_directions();
    const glm::vec3 inward = -point.normal;
    const glm::vec3 x =
        glm::normalize(glm::cross(inward, std::abs(inward.x) < 0.7f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0)));
    const glm::vec3 y = glm::cross(inward, x), from = point.position + kBelow * body_size * inward;
    float sum = 0.0f;
    for (const glm::vec3& d : kDirections)
        sum += d.z * caster.distance(from, d.x * x + d.y * y + d.z * inward, body_size);
    return sum / kRays;
}

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
    const float body_size = glm::length(extent), voxel = std::max({extent.x, extent.y, extent.z}) / float(resolution);
    const Caster caster(mesh);
    std::vector<float> found(points.size());
    parallel_for(0, points.size(), 256, [&](size_t first, size_t last) {
        for (size_t i = first; i < last; ++i) found[i] = thickness_at(points[i], caster, body_size);
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
