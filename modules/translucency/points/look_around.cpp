// What a surface's points see of their own body, in groups that lie together: each point's few rays alone would be seen
// as spots.

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

/// Of the points that face the ray.
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

/// The groups as points.
PointCloud grouped(const PointCloud& cloud) {
    PointCloud groups;
    groups.spacing = cloud.spacing * std::sqrt(float(PointCloud::kSightGroup));
    for (size_t first = 0; first < cloud.points.size(); first += PointCloud::kSightGroup) {
        SurfacePoint sum;
        for (size_t i = first; i < first + PointCloud::kSightGroup; ++i) {
            const SurfacePoint& point = cloud.points[i];
            sum.area += point.area;
            sum.position += point.area * point.position;
            sum.normal += point.area * point.normal;
        }
        sum.position /= sum.area;
        const float length = glm::length(sum.normal);
        sum.normal = length > 0.0f ? sum.normal / length : cloud.points[first].normal;
        groups.points.push_back(sum);
    }
    return groups;
}

/// Casts rays, each point in a pattern that is turned by another angle; has a cloud for as long as it is used.
struct Eyes {
    Eyes(const Mesh& mesh, const PointCloud& the_cloud)
        : cloud(the_cloud), triangles(mesh), inward(mesh, PointCloud::kSightRays), grid(the_cloud, mesh.bounds) {}

    /// Adds the groups that a point's rays meet but for its own, and gives the depth below it.
    float look(size_t i, std::vector<uint32_t>& met) const {
        const SurfacePoint& point = cloud.points[i];
        const glm::vec3 from = point.position + kAbove * cloud.spacing * point.normal;
        const float turn = kGoldenAngle * float(i % 4096);
        const glm::mat3 frame = frame_about(point.normal, turn);
        for (const glm::vec3& direction : directions) {
            const glm::vec3 along = frame * direction;
            const auto hit = triangles.cast(from, along);
            // a ray that begins below a triangle, as beside a crease, has met nothing
            if (!hit || !hit->front) continue;
            const uint32_t other = nearest(cloud, grid, from + hit->distance * along, along);
            if (other != kNothing && other / PointCloud::kSightGroup != i / PointCloud::kSightGroup)
                met.push_back(other / PointCloud::kSightGroup);
        }
        return inward.thickness(point.position, point.normal, turn);
    }

    const PointCloud& cloud;
    RayMesh triangles;
    InwardRays inward;
    PointGrid grid;
    std::vector<glm::vec3> directions = cosine_directions(PointCloud::kSightRays);
};

}  // namespace

void look_around(const Mesh& mesh, PointCloud& cloud) {
    const Eyes eyes(mesh, cloud);
    const PointCloud groups = grouped(cloud);
    std::vector<std::vector<uint32_t>> met(groups.points.size());
    cloud.depths.resize(groups.points.size());
    parallel_for(0, met.size(), 32, [&](size_t begin, size_t end) {
        for (size_t group = begin; group < end; ++group) {
            const size_t first = group * PointCloud::kSightGroup;
            float sum = 0.0f;
            for (size_t i = first; i < first + PointCloud::kSightGroup; ++i) sum += eyes.look(i, met[group]);
            cloud.depths[group] = sum / float(PointCloud::kSightGroup);
        }
    });
    cloud.sight_begins.assign(1, 0);
    for (const std::vector<uint32_t>& list : met) {
        cloud.sights.insert(cloud.sights.end(), list.begin(), list.end());
        cloud.sight_begins.push_back(uint32_t(cloud.sights.size()));
    }
    const PointGrid grid(groups, mesh.bounds);
    cloud.group_blends.resize(cloud.points.size());
    parallel_for(0, cloud.points.size(), 1024, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i)
            cloud.group_blends[i] = blended(groups, grid, cloud.points[i].position, cloud.points[i].normal);
    });
}

}  // namespace tyndall::translucency
