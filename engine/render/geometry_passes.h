#pragma once
/// Passes that draw surfaces: the fat G-buffer of the deferred path, the thin one and the material pass of the light
/// pre-pass path.

#include "render/frame_graph.h"

namespace tyndall {

class SpecularTableTexture;

/// Deferred: everything that lighting and compose need, in one geometry pass.
class GBufferPass final : public Pass {
 public:
    [[nodiscard]] std::string_view name() const override { return "gbuffer"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;
};

/// Light pre-pass: depth, normal, roughness and shading model alone.
class ThinGBufferPass final : public Pass {
 public:
    [[nodiscard]] std::string_view name() const override { return "thin_gbuffer"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;
};

/// Light pre-pass: draws the surfaces again and applies their materials to the light that was gathered.
class MaterialPass final : public Pass {
 public:
    explicit MaterialPass(SpecularTableTexture& table) : table_(table) {}
    [[nodiscard]] std::string_view name() const override { return "materials"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    SpecularTableTexture& table_;
};

}  // namespace tyndall
