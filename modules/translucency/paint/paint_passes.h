#pragma once
/// Paint over translucent solids, whatever technique renders them: what light it gets is kept before they take it
/// away, and mixed with theirs after.

#include <memory>

#include "render/light_programs.h"
#include "seen_surface.h"
#include "translucency_settings.h"

namespace tyndall::translucency {

/// Before all techniques.
class PaintMarkPass final : public Pass {
 public:
    PaintMarkPass(std::shared_ptr<TechniquePlan> plan, const TranslucencySettings& settings);
    [[nodiscard]] std::string_view name() const override { return "translucency.paint_mark"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    static void mark(PassContext& context);
    /// Looks at the lights once more, for a body whose pixels the light pass has given what leaves.
    void light_plainly(PassContext& context, const SeenSurface& seen);

    std::shared_ptr<TechniquePlan> plan_;
    const TranslucencySettings& settings_;
    LightPrograms programs_;
};

/// After all techniques.
class PaintMixPass final : public Pass {
 public:
    PaintMixPass(std::shared_ptr<TechniquePlan> plan, const TranslucencySettings& settings)
        : plan_(std::move(plan)), settings_(settings) {}
    [[nodiscard]] std::string_view name() const override { return "translucency.paint_mix"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    void mix(PassContext& context, const SeenSurface& seen, Technique technique);

    std::shared_ptr<TechniquePlan> plan_;
    const TranslucencySettings& settings_;
    PaintBinding binding_;
};

}  // namespace tyndall::translucency
