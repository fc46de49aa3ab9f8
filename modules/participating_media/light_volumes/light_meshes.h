#pragma once
/// The shadow meshes of lights on the GPU, made again when a shadow map was drawn again.

#include <vector>

#include "gpu/gpu.h"
#include "light_volumes/shadow_mesh.h"
#include "render/frame.h"

namespace tyndall::participating_media {

/// One mesh for each view of a light; for a directional light the widest cascade alone.
class LightMeshes {
 public:
    LightMeshes() = default;
    ~LightMeshes();
    LightMeshes(const LightMeshes&) = delete;
    LightMeshes& operator=(const LightMeshes&) = delete;

    /// Draws the faces of a light's meshes with the program in use; `world` holds what must be enclosed. Position is
    /// attribute 0. Reads shadow maps back when they have changed, which waits for the GPU.
    void draw(Frame& frame, size_t light, const Bounds& world, const ShadowMeshDetail& detail);
    /// The light has a shadow map.
    [[nodiscard]] static bool has_shadows(const Frame& frame, size_t light);

 private:
    struct Entry {
        uint64_t version = 0;
        float reach = 0.0f;
        ShadowMeshDetail detail;
        gpu::Buffer positions, indices;
        int index_count = 0;
    };
    static void refresh(Entry& entry, const ShadowView& view, bool of_cube, const gpu::Texture& maps);

    std::vector<Entry> entries_;  ///< by number of the view in the plan
    unsigned int vertex_array_ = 0;
};

}  // namespace tyndall::participating_media
