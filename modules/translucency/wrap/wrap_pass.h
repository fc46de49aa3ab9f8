#pragma once
/// The technique wrap: light that reaches around the body, each channel as far as it spreads.

#include <memory>

#include "body_size.h"
#include "render/kept.h"
#include "render/light_programs.h"
#include "seen_surface.h"
#include "translucency_settings.h"
#include "wrap/wrap_amount.h"

namespace tyndall::translucency {

class WrapPass final : public Pass {
 public:
    WrapPass(std::shared_ptr<TechniquePlan> plan, const TranslucencySettings& settings);

    [[nodiscard]] std::string_view name() const override { return "translucency.wrap"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    struct Object {
        InteriorBuffers interior;
        BodyRadius size;
        WrapAmount wrap;
    };

    const Object& object_of(const Surface& surface);
    void render(PassContext& context, const SeenSurface& seen, const Object& object);

    std::shared_ptr<TechniquePlan> plan_;
    const TranslucencySettings& settings_;
    KeptOfSurfaces<Object> objects_;
    LightPrograms programs_;
};

}  // namespace tyndall::translucency
