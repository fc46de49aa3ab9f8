#pragma once
/// A point cloud on the GPU, and the light of one object's points.

#include <cstdint>

#include "gpu/gpu.h"
#include "interior_buffers.h"
#include "points/point_cloud.h"

namespace tyndall::translucency {

/// What objects that share a mesh share.
struct GpuCloud {
    /// `shape`: what the mesh's axes were multiplied by before.
    GpuCloud(const PointCloud& cloud, const glm::vec3& shape);

    uint32_t points = 0, nodes = 0;
    int levels = 0;
    float spacing = 0.0f;  ///< of the mesh's space, as `radius`
    float radius = 0.0f;
    glm::vec3 shape{1.0f};
    uint32_t vertices = 0;
    int index_count = 0;
    gpu::Texture lists, pieces, blends;         ///< shaders/points
    gpu::Texture sights, groups, group_blends;  ///< likewise; none where no point sees another
    gpu::Buffer list_begins, positions, indices;
    [[nodiscard]] size_t bytes() const;
    [[nodiscard]] uint32_t first(int level) const { return 2 * points - (2 * points >> uint32_t(level)); }

 private:
    void add_sights(const PointCloud& cloud);
};

/// What each object has of its own.
struct GpuObject {
    /// `directional`: has room for the directions of light.
    GpuObject(const GpuCloud& cloud, bool directional);

    gpu::Texture node_places, node_fluxes, node_directions, point_scales, point_light, vertex_light, open_light,
        group_light;  ///< shaders/points
    InteriorBuffers interior;
};

}  // namespace tyndall::translucency
