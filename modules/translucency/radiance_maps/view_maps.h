#pragma once
/// What cameras all around an object see of it: places, in maps.

#include <cstdint>
#include <string>
#include <vector>

#include "gpu/gpu.h"
#include "gpu/shader_library.h"
#include "radiance_maps/body_mesh.h"

namespace tyndall::translucency {

/// Of a mesh; shared by the objects that have it.
class ViewMaps {
 public:
    static constexpr int kMaxViews = 64;
    static constexpr int kLevels = 3;  ///< the maps, halved and quartered

    ViewMaps(gpu::ShaderLibrary& shaders, const Mesh& mesh, int views, int resolution);

    [[nodiscard]] int views() const { return int(views_.size()); }
    [[nodiscard]] int resolution() const { return resolution_; }
    [[nodiscard]] const BodyMesh& mesh() const { return mesh_; }
    /// A layer a view, kLevels mips: place, packed normal plus 1; w = 0 where nothing is seen. A texel of a coarser
    /// level has the mean of those that lie near the foremost.
    [[nodiscard]] const gpu::Texture& places() const { return places_; }
    /// Texels where something is seen, x and y of 10 bits, then the view, in rows of kColumns.
    [[nodiscard]] const gpu::Texture& texels() const { return texels_; }
    [[nodiscard]] uint32_t texel_count() const { return texel_count_; }
    /// The uniform block "Views" of shaders/radiance_maps/views.glsl.
    [[nodiscard]] const gpu::Buffer& block() const { return block_; }
    /// As it is drawn: large triangles are cut.
    [[nodiscard]] const Mesh& drawn() const { return drawn_; }
    [[nodiscard]] size_t bytes() const;
    /// Draws what an object's kernel is multiplied by (attribute 2 of `own`) at the texels of `scales`, a layer a view.
    void draw_scales(gpu::ShaderLibrary& shaders, const gpu::Buffer& own, const gpu::Texture& scales) const;

    glm::vec3 middle{0.0f};  ///< of a sphere that holds the mesh
    float radius = 0.0f;
    float sphere_radius = 0.0f;  ///< 3 times the volume over the surface; 0 = open

 private:
    void draw(gpu::ShaderLibrary& shaders, const gpu::Buffer& own, const gpu::Texture& target,
              std::vector<std::string> defines) const;
    void list_and_halve();

    Mesh drawn_;
    std::vector<MapView> views_;
    int resolution_ = 0;
    uint32_t texel_count_ = 0;
    BodyMesh mesh_;
    gpu::Texture places_, texels_;
    gpu::Buffer block_;
};

}  // namespace tyndall::translucency
