#include "points/gpu_cloud.h"

#include <string_view>
#include <utility>
#include <vector>

namespace tyndall::translucency {
namespace {

constexpr int kNodeColumns = 256, kListColumns = 1024;  ///< as in shaders/points

gpu::TextureDesc table_desc(size_t texels) {
    return {.format = gpu::Format::rgba32f,
            .width = kNodeColumns,
            .height = (int(texels) + kNodeColumns - 1) / kNodeColumns};
}
/// A texture of kNodeColumns columns with `values` from its first texel on.
gpu::Texture table(std::vector<glm::vec4> values, std::string_view name) {
    const gpu::TextureDesc desc = table_desc(values.size());
    values.resize(size_t(desc.width) * size_t(desc.height));
    gpu::Texture made(desc, name);
    made.upload(0, 0, values.data());
    return made;
}
/// A texture of kListColumns columns; a float has 24 bits of a number exactly.
gpu::Texture numbers(std::span<const uint32_t> list, std::string_view name) {
    const gpu::TextureDesc desc{.format = gpu::Format::r32f,
                                .width = kListColumns,
                                .height = (int(list.size()) + kListColumns - 1) / kListColumns};
    std::vector<float> values(list.begin(), list.end());
    values.resize(size_t(desc.width) * size_t(desc.height), 0.0f);
    gpu::Texture made(desc, name);
    made.upload(0, 0, values.data());
    return made;
}
/// Numbers and weights of what is blended: 24 bits, which a float has exactly.
std::vector<glm::vec4> packed(const std::vector<PointCloud::Vertex>& blends) {
    std::vector<glm::vec4> both(blends.size());
    for (size_t i = 0; i < blends.size(); ++i)
        for (uint32_t k = 0; k < PointCloud::kNeighbours; ++k)
            both[i][int(k)] = float(blends[i].points[k] * 256u + blends[i].weights[k]);
    return both;
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
      vertices(uint32_t(cloud.vertices.size())),
      index_count(int(cloud.indices.size())) {
    if (cloud.points.empty()) return;
    std::vector<glm::vec4> surface;
    for (const SurfacePoint& point : cloud.points) {
        surface.emplace_back(point.position, point.area);
        surface.emplace_back(point.normal, 0.0f);
    }
    pieces = table(std::move(surface), "translucency.pieces");
    lists = numbers(cloud.lists, "translucency.lists");
    if (!cloud.sights.empty()) add_sights(cloud);
    list_begins = gpu::Buffer(std::span<const uint32_t>(cloud.list_begins), "translucency.list_begins");
    std::vector<glm::vec3> places;
    for (const PointCloud::Vertex& vertex : cloud.vertices) places.push_back(vertex.position);
    positions = gpu::Buffer(std::span<const glm::vec3>(places), "translucency.positions");
    blends = table(packed(cloud.vertices), "translucency.blends");
    indices = gpu::Buffer(std::span<const uint32_t>(cloud.indices), "translucency.indices");
}

void GpuCloud::add_sights(const PointCloud& cloud) {
    sights = numbers(cloud.sights, "translucency.sights");
    std::vector<glm::vec4> begins;
    for (size_t group = 0; group < cloud.depths.size(); ++group)
        begins.emplace_back(float(cloud.sight_begins[group]), float(cloud.sight_begins[group + 1]), cloud.depths[group],
                            0.0f);
    groups = table(std::move(begins), "translucency.groups");
    group_blends = table(packed(cloud.group_blends), "translucency.group_blends");
}

size_t GpuCloud::bytes() const {
    return bytes_of(lists) + bytes_of(sights) + bytes_of(groups) + bytes_of(group_blends) + bytes_of(pieces) +
           bytes_of(blends) + list_begins.size() + positions.size() + indices.size();
}

GpuObject::GpuObject(const GpuCloud& cloud, bool directional)
    : node_places(table_desc(cloud.nodes), "translucency.node_places"),
      node_fluxes(table_desc(cloud.nodes), "translucency.node_fluxes"),
      node_directions(directional ? table_desc(cloud.nodes) : table_desc(1), "translucency.node_directions"),
      point_scales(table_desc(cloud.points), "translucency.point_scales"),
      point_light(table_desc(2 * size_t(cloud.points)), "translucency.point_light"),
      vertex_light(table_desc(2 * size_t(cloud.vertices)), "translucency.vertex_light"),
      open_light(table_desc(cloud.points), "translucency.open_light"),
      group_light(table_desc(2 * size_t(cloud.points / PointCloud::kSightGroup)), "translucency.group_light") {
    open_light.clear(0, glm::vec4(0.0f));
    node_fluxes.clear(0, glm::vec4(0.0f));
}

}  // namespace tyndall::translucency
