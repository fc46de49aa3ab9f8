#pragma once
/// What the lights see of an object, and what enters it there.

#include <cstddef>
#include <vector>

#include "gpu/gpu.h"
#include "gpu/shader_library.h"
#include "radiance_maps/view_maps.h"
#include "scene/render_scene.h"

namespace tyndall::translucency {

/// Of one object: layers of one array, a layer a light; six for a light that is near the object or inside of it.
class LightMaps {
 public:
    static constexpr int kMaxLayers =
        160;  ///< as in shaders/radiance_maps/layers.glsl; a uniform block of 16 kB holds them

    struct Layer {
        MapView view;
        size_t light = 0;  ///< of the scene
    };

    /// Fits the layers to the object. Those that see it as before stay, also when object and light have moved together.
    /// True when one has changed: all has to be gathered anew.
    bool fit(const RenderScene& scene, const glm::mat4& world_from_body, const ViewMaps& body, int resolution);
    /// Draws places, normals and the vertices' scales into all layers.
    void draw(gpu::ShaderLibrary& shaders, const ViewMaps& body, const gpu::Buffer& scales);
    /// For the shaders that fill the entries, and those that gather from them.
    void bind(const gpu::Program& program) const;

    [[nodiscard]] const std::vector<Layer>& layers() const { return layers_; }
    [[nodiscard]] int resolution() const { return resolution_; }
    /// Lights that had no room.
    [[nodiscard]] size_t left_out() const { return left_out_; }
    [[nodiscard]] size_t bytes() const;

 private:
    void make_textures();
    void make_block();

    std::vector<Layer> layers_;
    size_t left_out_ = 0;
    int resolution_ = 0;
    gpu::Texture seen_places_, seen_scales_, depth_;      ///< as the triangles are drawn
    gpu::Texture entry_places_, entry_fluxes_, entered_;  ///< shaders/radiance_maps/enter.comp
    std::vector<gpu::Framebuffer> targets_;
    gpu::Buffer block_;
};

}  // namespace tyndall::translucency
