#pragma once
/// Thin surfaces that let light through: leaves, paper, cloth, lamp shades (Material::diffuse_transmission).

#include "render/frame_graph.h"
#include "render/pixel_rectangle.h"
#include "render/seams.h"
#include "scene/render_scene.h"
#include "translucency_settings.h"

namespace tyndall::translucency {

/// Whether diffuse light goes through a surface.
[[nodiscard]] bool is_leaf(const Surface& surface);

/// Where leaves may be seen in the picture.
[[nodiscard]] PixelRectangle pixels_of_leaves(PassContext& context);

/// The provider of the shading model "thin", which gives the light of both sides, by what share of their base each has
/// (MaterialPoint::through of render/shaders/material.glsl).
[[nodiscard]] SeamProvider thin_shading_model(const TranslucencySettings& settings);

/// Draws those shares, before lights are added, and gives the leaves light from all around. Does nothing in a scene
/// without.
class LeavesPass final : public Pass {
 public:
    explicit LeavesPass(const TranslucencySettings& settings) : settings_(settings) {}

    [[nodiscard]] std::string_view name() const override { return "translucency.leaves"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    static void draw_shares(PassContext& context);
    static void light_from_around(PassContext& context, const PixelRectangle& pixels);

    const TranslucencySettings& settings_;
};

}  // namespace tyndall::translucency
