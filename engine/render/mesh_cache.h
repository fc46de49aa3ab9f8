#pragma once
/// MeshAssets on the GPU.

#include <unordered_map>

#include "gpu/gpu.h"
#include "scene/render_scene.h"

namespace tyndall {

/// A mesh's buffers: positions alone for depth passes, the rest beside them.
struct GpuMesh {
    gpu::Buffer positions;   ///< vec3
    gpu::Buffer attributes;  ///< MeshVertex
    gpu::Buffer indices;     ///< 32 bits
    int index_count = 0;
    uint64_t last_used = 0;
};

/// What a vertex has besides its position.
struct MeshVertex {
    glm::vec3 normal;
    float curvature;    ///< 1 over the mesh's unit
    glm::vec4 tangent;  ///< w: sign of the bitangent
    glm::vec2 uv0;
    glm::vec2 uv1;
};

/// Uploads each mesh once, and frees what has not been asked for in a while. Owns the vertex format.
class MeshCache {
 public:
    MeshCache() = default;
    ~MeshCache();
    MeshCache(const MeshCache&) = delete;
    MeshCache& operator=(const MeshCache&) = delete;

    const GpuMesh& get(const MeshAsset& asset);
    /// Makes the vertex format current, with the surfaces' indices (uint, one an instance) from `instances`.
    void bind(const gpu::Buffer& instances);
    /// Points the vertex format at a mesh's buffers.
    void bind(const GpuMesh& mesh);
    /// Once a frame: frees meshes unused for kKeptFrames.
    void collect();

 private:
    static constexpr uint64_t kKeptFrames = 120;
    void create_format();
    std::unordered_map<uint64_t, GpuMesh> entries_;
    unsigned int vertex_array_ = 0;
    uint64_t frame_ = 0;
};

}  // namespace tyndall
