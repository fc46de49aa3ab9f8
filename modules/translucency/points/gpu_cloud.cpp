#include "points/gpu_cloud.h"

#include <vector>

namespace tyndall::translucency {

GpuCloud::GpuCloud(const PointCloud& cloud)
    : points(uint32_t(cloud.points.size())),
      nodes(2 * points - 1),
      levels(cloud.levels),
      spacing(cloud.spacing),
      radius(cloud.radius),
      index_count(int(cloud.indices.size())) {
    if (cloud.points.empty()) return;
    std::vector<glm::vec4> surface;
    for (const SurfacePoint& point : cloud.points) {
        surface.emplace_back(point.position, point.area);
        surface.emplace_back(point.normal, 0.0f);
    }
    pieces = gpu::Buffer(std::span<const glm::vec4>(surface), "translucency.pieces");
    lists = gpu::Buffer(std::span<const uint32_t>(cloud.lists), "translucency.lists");
    list_begins = gpu::Buffer(std::span<const uint32_t>(cloud.list_begins), "translucency.list_begins");
    vertices = gpu::Buffer(std::span<const PointCloud::Vertex>(cloud.vertices), "translucency.vertices");
    indices = gpu::Buffer(std::span<const uint32_t>(cloud.indices), "translucency.indices");
}

size_t GpuCloud::bytes() const {
    return pieces.size() + lists.size() + list_begins.size() + vertices.size() + indices.size();
}

GpuObject::GpuObject(const GpuCloud& cloud)
    : node_places(cloud.nodes * sizeof(glm::vec4), nullptr, "translucency.node_places"),
      node_fluxes(cloud.nodes * sizeof(glm::vec4), nullptr, "translucency.node_fluxes"),
      point_scales(cloud.points * sizeof(glm::vec4), nullptr, "translucency.point_scales"),
      point_light(2 * cloud.points * sizeof(glm::vec4), nullptr, "translucency.point_light") {}

}  // namespace tyndall::translucency
