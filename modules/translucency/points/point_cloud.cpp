#include "points/point_cloud.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

#include "body_size.h"
#include "core/parallel.h"

namespace tyndall::translucency {
namespace {

/// The sphere about each node's middle that holds its points.
struct Ball {
    glm::vec3 middle{0.0f};
    float radius = 0.0f;
};

std::vector<Ball> make_balls(const PointCloud& cloud) {
    const size_t count = cloud.points.size();
    std::vector<Ball> balls(2 * count - 1);
    for (size_t i = 0; i < count; ++i) balls[i].middle = cloud.points[i].position;
    for (int level = 1; level <= cloud.levels; ++level) {
        const size_t size = size_t(1) << size_t(level);
        for (size_t n = 0; n < count / size; ++n) {
            glm::dvec3 sum(0.0);
            double area = 0.0;
            for (size_t i = n * size; i < (n + 1) * size; ++i) {
                sum += double(cloud.points[i].area) * glm::dvec3(cloud.points[i].position);
                area += double(cloud.points[i].area);
            }
            Ball& ball = balls[cloud.first(level) + n];
            ball.middle = glm::vec3(sum / area);
            for (size_t i = n * size; i < (n + 1) * size; ++i)
                ball.radius = std::max(ball.radius, glm::distance(ball.middle, cloud.points[i].position));
        }
    }
    return balls;
}

/// Adds what a cluster gathers from a node: itself, or what its halves give.
void add_list(const PointCloud& cloud, const std::vector<Ball>& balls, const Ball& at, float opening, int level,
              uint32_t n, std::vector<uint32_t>& list) {
    const uint32_t node = cloud.first(level) + n;
    const float distance = glm::distance(balls[node].middle, at.middle) - at.radius;
    if (level == 0 || balls[node].radius < opening * distance) {
        list.push_back(node);
        return;
    }
    add_list(cloud, balls, at, opening, level - 1, 2 * n, list);
    add_list(cloud, balls, at, opening, level - 1, 2 * n + 1, list);
}

void make_lists(PointCloud& cloud, float opening) {
    const std::vector<Ball> balls = make_balls(cloud);
    const size_t clusters = cloud.points.size() / PointCloud::kCluster;
    const int cluster_level = std::countr_zero(PointCloud::kCluster);
    std::vector<std::vector<uint32_t>> lists(clusters);
    parallel_for(0, clusters, 16, [&](size_t begin, size_t end) {
        for (size_t c = begin; c < end; ++c) {
            const uint32_t node = cloud.first(cluster_level) + uint32_t(c);
            add_list(cloud, balls, balls[node], opening, cloud.levels, 0, lists[c]);
            std::ranges::sort(lists[c], std::greater{});  // groups have the greater numbers
        }
    });
    cloud.list_begins.assign(1, 0);
    for (const std::vector<uint32_t>& list : lists) {
        cloud.lists.insert(cloud.lists.end(), list.begin(), list.end());
        cloud.list_begins.push_back(uint32_t(cloud.lists.size()));
    }
}

}  // namespace

PointCloud make_point_cloud(const Mesh& mesh, int levels, float opening, bool interreflection) {
    PointCloud cloud;
    cloud.levels = levels;
    cloud.points = sample_surface(mesh, levels);
    if (cloud.points.empty()) return cloud;
    double area = 0.0;
    for (const SurfacePoint& point : cloud.points) area += double(point.area);
    cloud.spacing = float(std::sqrt(area / double(cloud.points.size())));
    cloud.radius = body_radius(mesh, glm::mat3(1.0f));
    make_lists(cloud, opening);
    if (interreflection) look_around(mesh, cloud);
    blend_points(mesh, cloud);
    return cloud;
}

}  // namespace tyndall::translucency
