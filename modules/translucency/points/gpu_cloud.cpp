#include "points/gpu_cloud.h"

#include <vector>

namespace tyndall::translucency {
namespace {

constexpr int kNodeColumns = 256, kListColumns = 1024;  ///< as in shaders/points

gpu::TextureDesc table_desc(size_t texels) {
    return {.format = gpu::Format::rgba32f,
            .width = kNodeColumns,
            .height = (int(texels) + kNodeColumns - 1) / kNodeColumns};
}
size_t bytes_of(const gpu::Texture& texture) {
    return gpu::bytes_per_texel(texture.desc().format) * size_t(texture.desc().width) * size_t(texture.desc().height);
}

}  // namespace

GpuCloud::GpuCloud(const PointCloud& cloud, const glm::vec3& the_shape)
    : points(uint32_t(cloud.points.size())),
      nodes(2 * points),
      levels(cloud.levels),
      spacing(cloud.spacing),
      radius(cloud.radius),
      shape(the_shape),
      index_count(int(cloud.indices.size())) {
    if (cloud.points.empty()) return;
    std::vector<glm::vec4> surface;
    for (const SurfacePoint& point : cloud.points) {
        surface.emplace_back(point.position, point.area);
        surface.emplace_back(point.normal, 0.0f);
    }
    const gpu::TextureDesc two_a_point = table_desc(surface.size());
    surface.resize(size_t(two_a_point.width) * size_t(two_a_point.height));
    pieces = gpu::Texture(two_a_point, "translucency.pieces");
    pieces.upload(0, 0, surface.data());
    const gpu::TextureDesc desc{.format = gpu::Format::r32f,
                                .width = kListColumns,
                                .height = (int(cloud.lists.size()) + kListColumns - 1) / kListColumns};
    std::vector<float> numbers(cloud.lists.begin(), cloud.lists.end());
    numbers.resize(size_t(desc.width) * size_t(desc.height), 0.0f);
    lists = gpu::Texture(desc, "translucency.lists");
    lists.upload(0, 0, numbers.data());
    list_begins = gpu::Buffer(std::span<const uint32_t>(cloud.list_begins), "translucency.list_begins");
    vertices = gpu::Buffer(std::span<const PointCloud::Vertex>(cloud.vertices), "translucency.vertices");
    indices = gpu::Buffer(std::span<const uint32_t>(cloud.indices), "translucency.indices");
}

size_t GpuCloud::bytes() const {
    return bytes_of(lists) + bytes_of(pieces) + list_begins.size() + vertices.size() + indices.size();
}

GpuObject::GpuObject(const GpuCloud& cloud, bool directional)
    : node_places(table_desc(cloud.nodes), "translucency.node_places"),
      node_fluxes(table_desc(cloud.nodes), "translucency.node_fluxes"),
      node_directions(directional ? table_desc(cloud.nodes) : table_desc(1), "translucency.node_directions"),
      point_scales(table_desc(cloud.points), "translucency.point_scales"),
      point_light(table_desc(2 * cloud.points), "translucency.point_light") {
    node_fluxes.clear(0, glm::vec4(0.0f));
}

}  // namespace tyndall::translucency
