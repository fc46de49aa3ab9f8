#pragma once
/// Thin surfaces that let light through: leaves, paper, cloth, lamp shades (Material::diffuse_transmission).

#include "render/frame_graph.h"
#include "render/light_programs.h"
#include "render/pixel_rectangle.h"
#include "translucency_settings.h"

namespace tyndall::translucency {

/// Whether diffuse light goes through a surface.
[[nodiscard]] bool is_leaf(const Surface& surface);

/// Turns the irradiance of their near side into that of both sides, by what share of their base each has
/// (MaterialPoint::through of render/shaders/material.glsl). Does nothing in a scene without.
class LeavesPass final : public Pass {
 public:
    explicit LeavesPass(const TranslucencySettings& settings);

    [[nodiscard]] std::string_view name() const override { return "translucency.leaves"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    static void draw_shares(PassContext& context);
    static void begin(PassContext& context, const PixelRectangle& pixels);
    /// `begun`: the near side's light has been taken its part from already.
    void add_lights(PassContext& context, const PixelRectangle& pixels, bool begun);

    const TranslucencySettings& settings_;
    LightPrograms programs_;
};

}  // namespace tyndall::translucency
