#include "points/cloud_store.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/log.h"

namespace tyndall::translucency {
namespace {

float area_of(const Mesh& mesh, const glm::vec3& shape) {
    double twice = 0.0;
    for (size_t t = 0; t < mesh.triangle_count(); ++t) {
        const glm::vec3 a = shape * mesh.positions[mesh.indices[3 * t]];
        const glm::vec3 b = shape * mesh.positions[mesh.indices[3 * t + 1]];
        const glm::vec3 c = shape * mesh.positions[mesh.indices[3 * t + 2]];
        twice += double(glm::length(glm::cross(b - a, c - a)));
    }
    return float(0.5 * twice);
}

}  // namespace

const GpuCloud& CloudStore::cloud(const Surface& surface, int levels, const PointsSettings& wanted) {
    const glm::vec3 shape = shape_of(surface.transform);
    Cloud& cloud = clouds_.at({shape_key(surface), levels});
    if (cloud.gpu && cloud.opening == wanted.opening && cloud.interreflection == wanted.interreflection)
        return *cloud.gpu;
    const auto begun = std::chrono::steady_clock::now();
    const Mesh& mesh = surface.mesh->mesh;
    const bool as_it_is = shape == glm::vec3(1.0f);
    const PointCloud made =
        make_point_cloud(as_it_is ? mesh : stretched(mesh, shape), levels, wanted.opening, wanted.interreflection);
    cloud.gpu = std::make_unique<GpuCloud>(made, shape);
    cloud.opening = wanted.opening;
    cloud.interreflection = wanted.interreflection;
    log::info("translucency: {}: {} points, {} to gather from on average, {:.1f} MB, {:.2f} s", surface.mesh->name,
              made.points.size(),
              made.points.empty() ? 0 : made.lists.size() * PointCloud::kCluster / made.points.size(),
              double(cloud.gpu->bytes()) / 1048576.0,
              std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count());
    return *cloud.gpu;
}

float CloudStore::area(const Surface& surface) {
    const glm::vec3 shape = shape_of(surface.transform);
    std::optional<float>& area = areas_.at(shape_key(surface));
    if (!area) area = area_of(surface.mesh->mesh, shape);
    const float volume = std::abs(glm::determinant(glm::mat3(surface.transform))) / (shape.x * shape.y * shape.z);
    return *area * std::pow(volume, 2.0f / 3.0f);
}

void CloudStore::end_frame() {
    clouds_.end_frame();
    areas_.end_frame();
}

}  // namespace tyndall::translucency
