#pragma once
/// The quick techniques, wrap and thickness: the light pass itself gives the light that leaves, by a shading model.

#include <memory>

#include "quick/quick_table.h"
#include "render/kept.h"
#include "thickness/thickness_shares.h"

namespace tyndall::translucency {

/// The provider of the shading model "interior", which all boundaries of interiors that scatter have.
[[nodiscard]] SeamProvider interior_shading_model(std::shared_ptr<QuickTable> table);

/// Before lights are added: finds the bodies, draws what goes through those of the technique thickness, and turns light
/// from all around into what leaves of it.
class QuickPass final : public Pass {
 public:
    QuickPass(std::shared_ptr<TechniquePlan> plan, std::shared_ptr<QuickTable> table,
              const TranslucencySettings& settings)
        : plan_(std::move(plan)), table_(std::move(table)), settings_(settings) {}

    [[nodiscard]] std::string_view name() const override { return "translucency.quick"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    void add(PassContext& context, const SeenSurface& seen, QuickKind kind);
    [[nodiscard]] glm::vec4 lobe_of(const QuickBody& body, const Optics& optics) const;

    std::shared_ptr<TechniquePlan> plan_;
    std::shared_ptr<QuickTable> table_;
    const TranslucencySettings& settings_;
    KeptOfSurfaces<QuickBody> bodies_;
    ThicknessShares shares_;
    uint64_t made_ = 0;  ///< bodies' patterns
};

}  // namespace tyndall::translucency
