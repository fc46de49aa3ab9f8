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
#include "splats.h"

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

}  // namespace

ThicknessGrid make_thickness_grid(const Mesh& mesh, int resolution) {
    const std::vector<SurfacePoint> points = sample_surface(mesh, kLevels);
    ThicknessGrid grid;
    if (points.empty()) return grid;
    const glm::vec3 extent = mesh.bounds.high - mesh.bounds.low;
    const float body_size = glm::length(extent);
    const Caster caster(mesh);
    std::vector<float> found(points.size());
    parallel_for(0, points.size(), 256, [&](size_t first, size_t last) {
        for (size_t i = first; i < last; ++i) found[i] = thickness_at(points[i], caster, body_size);
    });
    const SurfaceGrid place(mesh.bounds, resolution);
    grid.box = place.box;
    grid.size = place.size;
    Splats<float> splats(place);
    double sum = 0.0;
    for (size_t i = 0; i < points.size(); ++i) {
        splats.add(points[i].position, found[i], 1.0f);
        sum += double(found[i]);
    }
    splats.widen();
    splats.widen();
    grid.thickness = splats.means();
    grid.mean = float(sum / double(points.size()));
    return grid;
}

}  // namespace tyndall::translucency
