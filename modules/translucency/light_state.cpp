#include "light_state.h"

#include <vector>

#include "render/frame.h"
#include "render/light_buffer.h"
#include "render/shadow_maps.h"

namespace tyndall::translucency {

void append_light_state(std::string& state, const Frame& frame, size_t light, uint64_t frame_number) {
    append_state(state, frame.lights.lights()[light]);
    const auto& gobo = frame.scene.lights[light].gobo;
    append_state(state, gobo ? gobo->id : uint64_t(0));
    const std::vector<ShadowView>& views = frame.shadow_maps.plan().views;
    for (size_t i = 0; i < views.size(); ++i)
        if (views[i].light == light) append_state(state, frame.shadow_maps.version(i));
    if (!frame.scene.media.empty()) append_state(state, frame_number);
}

}  // namespace tyndall::translucency
