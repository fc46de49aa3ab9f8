#pragma once
// The module "painter": a pass that fills a target with a colour, and a seam that puts it before everything. Its two
// versions differ in the colour.

#include "module/module.h"
#include "render/frame.h"

namespace tyndall::painter {

class FillPass final : public Pass {
 public:
    explicit FillPass(glm::vec3 colour) : colour_(colour) {}
    [[nodiscard]] std::string_view name() const override { return "painter.fill"; }
    void declare(PassDeclaration& declaration) override {
        declaration.stage(Stage::media)
            .writes("paint", {.format = gpu::Format::rgba16f}, "the colour")
            .writes("paint_kept", {.own = [this] { return &kept_; }}, "a texture that lives as long as the pass")
            .keep();
    }
    void execute(PassContext& context) override {
        if (kept_.name() == 0)
            kept_ = gpu::Texture({.format = gpu::Format::rgba8, .width = 4, .height = 4}, "paint_kept");
        const gpu::Program& program =
            context.frame().shaders.program({.name = "painter.fill", .fragment = "painter/fill.frag"});
        const std::string_view target = "paint";
        context.bind_targets(std::span(&target, 1), -1);
        program.use();
        program.set("colour", colour_);
        gpu::draw_fullscreen();
    }

 private:
    glm::vec3 colour_;
    gpu::Texture kept_;
};

inline void install_painter(Registrar& registrar, glm::vec3 colour) {
    registrar.pass(std::make_unique<FillPass>(colour));
    registrar.seam(Seam::media_segment, {.name = "painter",
                                         .include = "painter/segment.glsl",
                                         .function = "painter_segment",
                                         .reads = {"paint"},
                                         .bind = [](const gpu::Program& program, PassContext& context) {
                                             program.texture("paint", context.texture("paint"),
                                                             {.filter = gpu::Filter::nearest});
                                         }});
}

}  // namespace tyndall::painter
