#pragma once
/// Paint over translucent solids, whatever technique renders them: what light it gets is kept before they take it
/// away, and mixed with theirs after.

#include <memory>

#include "seen_surface.h"
#include "translucency_settings.h"

namespace tyndall::translucency {

/// Before all techniques.
class PaintMarkPass final : public Pass {
 public:
    explicit PaintMarkPass(const TranslucencySettings& settings) : settings_(settings) {}
    [[nodiscard]] std::string_view name() const override { return "translucency.paint_mark"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    const TranslucencySettings& settings_;
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
