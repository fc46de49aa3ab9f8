// What a surface's points see of their own body.

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "core/parallel.h"
#include "geometry/ray_mesh.h"
#include "geometry/thickness.h"
#include "points/point_cloud.h"
#include "points/point_grid.h"

namespace tyndall::translucency {
namespace {

constexpr float kGoldenAngle = std::numbers::pi_v<float> * 0.76393202f;  // (3 - sqrt 5)
/// Rays begin so far above the surface, in spacings of the points.
constexpr float kAbove = 0.02f;
constexpr uint32_t kNothing = std::numeric_limits<uint32_t>::max();

/// Spread as the cosine to the normal is; each point turns the pattern by another angle.
glm::vec3 direction(const glm::vec3& normal, int ray, size_t point) {
    const glm::vec3 x =
        glm::normalize(glm::cross(normal, std::abs(normal.x) < 0.7f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0)));
    const float share = (float(ray) + 0.5f) / float(PointCloud::kSightRays), radius = std::sqrt(share);
    const float angle = kGoldenAngle * float(ray + int(point % 4096));
    return radius * (std::cos(angle) * x + std::sin(angle) * glm::cross(normal, x)) + std::sqrt(1.0f - share) * normal;
}

/// Of those that face the ray.
uint32_t nearest(const PointCloud& cloud, const PointGrid& grid, const glm::vec3& at, const glm::vec3& along) {
    uint32_t found = kNothing;
    float least = std::numeric_limits<float>::max();
    for (int reach = 1; found == kNothing && reach <= 4; reach *= 2)
        grid.near(at, reach, [&](uint32_t i) {
            const glm::vec3 apart = cloud.points[i].position - at;
            if (glm::dot(cloud.points[i].normal, along) >= 0.0f || glm::dot(apart, apart) >= least) return;
            least = glm::dot(apart, apart);
            found = i;
        });
    return found;
}

}  // namespace

void look_around(const Mesh& mesh, PointCloud& cloud) {
    const RayMesh triangles(mesh);
    const PointGrid grid(cloud, mesh.bounds);
    const InwardRays inward(mesh, PointCloud::kSightRays);
    std::vector<std::vector<uint32_t>> seen(cloud.points.size());
    cloud.depths.resize(cloud.points.size());
    parallel_for(0, seen.size(), 256, [&](size_t first, size_t last) {
        for (size_t i = first; i < last; ++i) {
            const SurfacePoint& point = cloud.points[i];
            cloud.depths[i] = inward.thickness(point.position, point.normal, kGoldenAngle * float(i % 4096));
            const glm::vec3 from = point.position + kAbove * cloud.spacing * point.normal;
            for (int ray = 0; ray < PointCloud::kSightRays; ++ray) {
                const glm::vec3 along = direction(point.normal, ray, i);
                const auto hit = triangles.cast(from, along);
                // a ray that begins below a triangle, as beside a crease, has met nothing
                if (!hit || !hit->front) continue;
                const uint32_t met = nearest(cloud, grid, from + hit->distance * along, along);
                if (met != kNothing && met != i) seen[i].push_back(met);
            }
        }
    });
    cloud.sight_begins.assign(1, 0);
    for (const std::vector<uint32_t>& points : seen) {
        cloud.sights.insert(cloud.sights.end(), points.begin(), points.end());
        cloud.sight_begins.push_back(uint32_t(cloud.sights.size()));
    }
}

}  // namespace tyndall::translucency
