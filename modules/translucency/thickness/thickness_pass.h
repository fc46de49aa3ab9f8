#pragma once
/// The technique thickness: wrapped light through the body by its local thickness (Barre-Brisebois & Bouchard 2011).

#include <memory>

#include "body_size.h"
#include "body_space.h"
#include "render/kept.h"
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
    struct Grid {
        gpu::Texture texture;
        glm::mat4 grid_from_shape{1.0f};  ///< from the stretched mesh's space
        glm::vec3 shape{1.0f};
        bool made = false;
    };
    struct Object {
        InteriorBuffers interior;
        BodyRadius size;
        WrapAmount wrap;
        gpu::Texture through;
        float farthest = 0.0f;
    };

    const Grid& grid_of(const Surface& surface);
    const Object& object_of(const Surface& surface);
    void render(PassContext& context, const SeenSurface& seen);
    [[nodiscard]] glm::vec4 lobe_of(const Object& object, const Optics& optics) const;

    std::shared_ptr<TechniquePlan> plan_;
    const TranslucencySettings& settings_;
    Kept<ShapeKey, Grid> grids_;
    KeptOfSurfaces<Object> objects_;
    LightPrograms programs_;
};

}  // namespace tyndall::translucency
