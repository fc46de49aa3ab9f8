#pragma once
/// Meshes, textures and materials on the GPU, and drawing a RenderScene's surfaces with them.
///
/// Uploads happen on first use, keyed by the assets' ids, and are freed when unused for a while. Surfaces that share
/// mesh and material are drawn as instances of one call.

#include <functional>
#include <glm/mat4x4.hpp>
#include <memory>
#include <string>
#include <vector>

#include "gpu/gpu.h"
#include "gpu/shader_library.h"
#include "scene/render_scene.h"

namespace tyndall {

class Seams;

/// Which surfaces to draw, and from where.
struct DrawView {
    glm::mat4 clip_from_world{1.0f};  ///< surfaces outside its side and far planes are left out
    glm::vec3 eye{0.0f};              ///< nearest surfaces come first
    uint32_t features = 0;            ///< materials without all of these (MaterialFeature) are left out
    bool casters_only = false;        ///< leaves out those that cast no shadow, and draws the others from both sides
};

/// A way to draw surfaces: the vertex shader render/shaders/surface.vert, and a fragment shader that includes
/// render/shaders/material.glsl. It is compiled once for each set of features that materials ask for.
struct SurfaceShader {
    std::string name;                  ///< for messages and timings
    std::string fragment;              ///< file
    std::vector<std::string> defines;  ///< besides those of the features
};

/// A frame's surfaces on the GPU.
class GpuScene {
 public:
    explicit GpuScene(gpu::ShaderLibrary& shaders);
    ~GpuScene();
    GpuScene(const GpuScene&) = delete;
    GpuScene& operator=(const GpuScene&) = delete;

    /// Once a frame, before drawing: uploads what is new, fills the blocks of surfaces and materials, frees what has
    /// been unused for some frames. `seams` numbers the shading models.
    void update(const RenderScene& scene, const Seams& seams);

    /// Draws into the bound framebuffer with the depth state as it is. `bind` is called after use() of each program
    /// that takes part, to set what the shader needs besides surfaces and materials; it may be empty. Culls back faces
    /// but those of double-sided materials. Returns the triangles drawn.
    size_t draw(const DrawView& view, const SurfaceShader& shader,
                const std::function<void(const gpu::Program&)>& bind);
    /// Fills the bound depth target alone (shadow maps, prepasses).
    size_t draw_depth(const DrawView& view);

    /// Draws one mesh with the program in use and the state as it is: attribute 0 is the position in the mesh's space.
    void draw_mesh(const MeshAsset& mesh);

    /// Changes when what `draw_depth` with `casters_only` would draw in this view changes: a cached shadow map is good
    /// as long as this and its matrix stay the same.
    [[nodiscard]] uint64_t casters_hash(const glm::mat4& clip_from_world) const;

    /// The asset as a texture, rows as they are: v = 0 is the image's top, as in glTF.
    [[nodiscard]] const gpu::Texture& texture(const TextureAsset& asset);

    /// Of all surfaces of the frame; empty without any.
    [[nodiscard]] const Bounds& bounds() const;
    /// Triangles drawn since the last update, all passes together.
    [[nodiscard]] size_t triangles_drawn() const;

 private:
    struct Implementation;
    std::unique_ptr<Implementation> self_;
};

}  // namespace tyndall
