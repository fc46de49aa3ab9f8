#pragma once
/// The technique thickness: wrapped light through the body by its local thickness (Barre-Brisebois & Bouchard 2011).

#include <map>
#include <memory>
#include <tuple>
#include <utility>

#include "body_size.h"
#include "render/light_programs.h"
#include "seen_surface.h"
#include "translucency_settings.h"
#include "wrap/wrap_amount.h"

namespace tyndall::translucency {

class ThicknessPass final : public Pass {
 public:
    ThicknessPass(std::shared_ptr<TechniquePlan> plan, const TranslucencySettings& settings);

    [[nodiscard]] std::string_view name() const override { return "translucency.thickness"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    /// By mesh and how it is stretched.
    struct Grid {
        gpu::Texture texture;
        glm::mat4 grid_from_shape{1.0f};  ///< from the stretched mesh's space
        glm::vec3 shape{1.0f};
        bool made = false;
        uint64_t last_used = 0;
    };
    struct Object {
        InteriorBuffers interior;
        BodyRadius size;
        WrapAmount wrap;
        gpu::Texture through;
        float farthest = 0.0f;
        uint64_t last_used = 0;
    };
    using ObjectKey = std::pair<uint64_t, uint64_t>;  ///< entity and mesh

    const Grid& grid_of(const Surface& surface);
    const Object& object_of(const Surface& surface);
    void render(PassContext& context, const SeenSurface& seen);
    [[nodiscard]] glm::vec4 lobe_of(const Object& object, const Optics& optics) const;

    std::shared_ptr<TechniquePlan> plan_;
    const TranslucencySettings& settings_;
    std::map<std::tuple<uint64_t, float, float, float>, Grid> grids_;
    std::map<ObjectKey, Object> objects_;
    LightPrograms programs_;
    uint64_t frame_ = 0;
};

}  // namespace tyndall::translucency
