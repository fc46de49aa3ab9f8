#pragma once
/// From radiance to what the display is sent.

#include <string>

#include "render/display_transform.h"
#include "render/frame_graph.h"
#include "render/image_settings.h"

namespace tyndall {

/// Exposure, OpenColorIO's display transform, dither. With antialiasing to follow it keeps 16 bits instead and leaves
/// the dither to the next pass.
class DisplayPass final : public Pass {
 public:
    explicit DisplayPass(DisplayTransform& transform) : transform_(transform) {}
    [[nodiscard]] std::string_view name() const override { return "display"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;
    /// Whether an AntialiasPass follows; the graph must be rebuilt after a change.
    void set_antialiased(bool antialiased) { antialiased_ = antialiased; }

 private:
    DisplayTransform& transform_;
    bool antialiased_ = false;
};

/// Smooths jagged edges of the encoded picture (after FXAA, Lottes 2009), then dithers it to 8 bits.
class AntialiasPass final : public Pass {
 public:
    [[nodiscard]] std::string_view name() const override { return "antialias"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;
};

/// Shows a target of the frame in place of the picture: depth as distance, normals as colours, radiance and light
/// through the display transform, the layers of an array side by side.
class ViewPass final : public Pass {
 public:
    explicit ViewPass(DisplayTransform& transform) : transform_(transform) {}
    [[nodiscard]] std::string_view name() const override { return "view"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;
    /// The target to show; the graph must be rebuilt after a change.
    void set_target(std::string target) { target_ = std::move(target); }

 private:
    DisplayTransform& transform_;
    std::string target_;
};

}  // namespace tyndall
