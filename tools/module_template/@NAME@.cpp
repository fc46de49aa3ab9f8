// The module @NAME@: one component, drawn through the media-segment seam. docs/modules.md says what else a module can register.

#include "@NAME@_component.h"
#include "module/module.h"
#include "render/frame.h"

namespace tyndall::@NAME@ {

/// The component as this frame has it.
struct FrameState {
    @Name@Component value;
    uint64_t frame = ~uint64_t{0};
};

class @Name@ final : public Module {
public:
    void install(Registrar& registrar) override {
        const auto state = std::make_shared<FrameState>();
        registrar.component<@Name@Component>([state](const ExtractContext&, const void* component, RenderScene& scene) {
            state->value = *static_cast<const @Name@Component*>(component);
            state->frame = scene.frame;
        });
        registrar.seam(Seam::media_segment, {.name = "@NAME@",
                                             .include = "@NAME@/@NAME@.glsl",
                                             .function = "@NAME@_segment",
                                             .reads = {},
                                             .bind = [state](const gpu::Program& program, PassContext& context) {
                                                 const bool present = state->frame == context.frame().scene.frame;
                                                 program.set("@NAME@_radiance", state->value.radiance_cd_m2);
                                                 program.set("@NAME@_density", present ? state->value.density_per_m : 0.0f);
                                             }});
    }
};

}  // namespace tyndall::@NAME@

TYNDALL_MODULE(tyndall::@NAME@::@Name@, "0.1", "A veil that thickens with the distance from the eye.", "")
