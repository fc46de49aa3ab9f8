#pragma once
/// Programs that look at one light a draw, compiled for what is known of it.

#include <array>

#include "gpu/shader_library.h"
#include "render/frame.h"

namespace tyndall {

/// The variants of a program for kinds of lights, with and without gobo and shadows (render/shaders/lights.glsl).
///
///     const gpu::Program& program = programs_.use(frame, light, [&](const gpu::Program& fresh) { ...bind the rest...
///     }); gpu::draw_fullscreen();
class LightPrograms {
 public:
    /// `base` is completed by the defines ONE_LIGHT, LIGHT_KIND, LIGHT_GOBO, LIGHT_HIGHLIGHT and
    /// SHADOW_VIEWS.
    explicit LightPrograms(gpu::ProgramDesc base);

    /// Before a pass's first light: nothing is in use.
    void begin() { current_ = nullptr; }
    /// Uses the program for this light of the frame's scene and binds the light. `bind` is called when the program is
    /// another than the last light's, for all that does not depend on the light.
    template <class Bind>
    const gpu::Program& use(Frame& frame, size_t light, const Bind& bind) {
        const gpu::Program& program = frame.shaders.program(variant(frame, light));
        if (&program != current_) {
            current_ = &program;
            program.use();
            bind_frame(program, frame);
            bind(program);
        }
        bind_light(program, frame, light);
        return program;
    }

 private:
    static constexpr size_t kKinds = 3, kViews = 7;
    [[nodiscard]] const gpu::ProgramDesc& variant(const Frame& frame, size_t light);

    gpu::ProgramDesc base_;
    std::array<gpu::ProgramDesc, kKinds * 2 * 2 * kViews> variants_;
    const gpu::Program* current_ = nullptr;
};

}  // namespace tyndall
