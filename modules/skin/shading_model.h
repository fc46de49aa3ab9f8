#pragma once
/// The shading model "skin": the oily layer, and what the techniques of the light pass make of diffuse light.

#include <map>
#include <memory>
#include <vector>

#include "gpu/gpu.h"
#include "render/seams.h"
#include "response.h"
#include "skin_plan.h"

namespace tyndall::skin {

/// What shaders know of the scene's surfaces by their numbers (shaders/surfaces.glsl), and the tables.
class SkinTables {
 public:
    /// Brings the tables to the frame's scene and binds them.
    void bind(const gpu::Program& program, const RenderScene& scene);
    /// The table of surfaces alone.
    void bind_surfaces(const gpu::Program& program, const RenderScene& scene);
    /// The profiles of the scene that `update` last saw, and for as long as it lives; the table numbers them from 1 on.
    [[nodiscard]] const std::vector<const physics::DiffusionProfile*>& profiles() const { return profiles_; }
    /// What the light pass knows of the scene's surface `index`, of the scene that `update` last saw: layer of the
    /// responses, strength of the mirror, layer of the mirrors.
    [[nodiscard]] glm::vec3 layers(size_t index) const;
    /// Finds the profiles and fills the table; the others do it when needed.
    void update(const RenderScene& scene);

 private:
    struct Layer {
        Technique technique;
        physics::DiffusionProfile profile;
        physics::ProfileCorrections corrections;
        bool operator==(const Layer&) const = default;
    };

    size_t layer_of(const SurfaceDiffusion& diffusion, std::vector<Layer>& layers) const;
    static Response response_of(const Layer& layer);
    size_t profile_of(const SurfaceDiffusion& diffusion);
    void upload_layers(const std::vector<Layer>& layers);
    void upload_layer_tables(const std::vector<glm::vec4>& parameters);

    std::vector<const physics::DiffusionProfile*> profiles_;
    std::vector<glm::vec4> rows_, uploaded_rows_;
    std::vector<Layer> layers_;
    std::vector<glm::vec4> parameters_;
    gpu::Texture surfaces_, responses_, shadows_, mirrors_;
};

/// The provider of Seam::shading_model.
[[nodiscard]] SeamProvider shading_model(std::shared_ptr<SkinTables> tables);

}  // namespace tyndall::skin
