#pragma once
/// From light buffers to radiance: compose, sky, media.

#include "render/frame_graph.h"
#include "render/seams.h"
#include "render/specular_table.h"

namespace tyndall {

/// Deferred: creates "radiance" from the light buffers and the G-buffer.
class ComposePass final : public Pass {
 public:
    explicit ComposePass(SpecularTableTexture& table) : table_(table) {}
    [[nodiscard]] std::string_view name() const override { return "compose"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    SpecularTableTexture& table_;
};

/// Fills what no surface covers through the sky seam.
class SkyPass final : public Pass {
 public:
    explicit SkyPass(Seams& seams) : seams_(seams) {}
    [[nodiscard]] std::string_view name() const override { return "sky"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    Seams& seams_;
};

/// Dims everything by the media between it and the eye, and adds what they scatter, through the media-segment seam.
/// Without a provider it has nothing to do and should be left out.
class MediaPass final : public Pass {
 public:
    explicit MediaPass(Seams& seams) : seams_(seams) {}
    [[nodiscard]] std::string_view name() const override { return "media"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    Seams& seams_;
};

}  // namespace tyndall
