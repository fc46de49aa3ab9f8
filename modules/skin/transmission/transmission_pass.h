#pragma once
/// Light through thin parts: ears, nostrils, lips.

#include <memory>

#include "render/frame_graph.h"
#include "render/light_programs.h"
#include "screen/screen_settings.h"
#include "shading_model.h"
#include "transmission/transmission_tables.h"

namespace tyndall::skin {

/// Skin by how light spreads under it: techniques in the map overwrite what the light buffer has.
enum class SpreadIn { light_or_screen, map };

/// Adds to the light buffer what of lights with shadow maps has come through the skin to where it is seen (after
/// Jimenez et al., Real-Time Realistic Skin Translucency, 2010): before light spreads on the screen, after it has in
/// the map. Where the body's thickness is known, light without a shadow map comes through as through a slab as thick,
/// and all light where the scene wants it.
class TransmissionPass final : public Pass {
 public:
    TransmissionPass(std::shared_ptr<SkinTables> tables, const SkinSettings& settings, SpreadIn spread);

    [[nodiscard]] std::string_view name() const override {
        return spread_ == SpreadIn::map ? "skin.transmission_map" : "skin.transmission";
    }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    void rings(PassContext& context);
    void slabs(PassContext& context, float largest_use);
    void around(PassContext& context);
    void bind(PassContext& context, const gpu::Program& program, float least_use);

    std::shared_ptr<SkinTables> tables_;
    const SkinSettings& settings_;
    SpreadIn spread_;
    TransmissionTables shares_;
    LightPrograms ring_programs_, slab_programs_;
};

}  // namespace tyndall::skin
