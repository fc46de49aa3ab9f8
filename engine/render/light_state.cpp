#include "render/light_state.h"

#include <algorithm>
#include <vector>

#include "render/frame.h"
#include "render/light_buffer.h"
#include "render/seams.h"
#include "render/shadow_maps.h"
#include "scene/environment.h"

namespace tyndall {

void append_light_state(std::string& state, const Frame& frame, size_t light, uint64_t frame_number) {
    append_state(state, frame.lights.lights()[light]);
    const auto& gobo = frame.scene.lights[light].gobo;
    append_state(state, gobo ? gobo->id : uint64_t(0));
    const std::vector<ShadowView>& views = frame.shadow_maps.plan().views;
    for (size_t i = 0; i < views.size(); ++i)
        if (views[i].light == light) append_state(state, frame.shadow_maps.version(i));
    if (!frame.scene.media.empty()) append_state(state, frame_number);
}

bool has_light_all_around(const RenderScene& scene) {
    const auto boxed = [](const LightProbe& probe) { return probe.extent_m.has_value(); };
    if (std::ranges::any_of(scene.probes, boxed)) return true;
    const Environment environment = environment_of(scene);
    return environment.radiance != glm::vec3(0.0f) && environment.lights.count <= 0;
}

bool has_surroundings(const RenderScene& scene) {
    return !scene.probes.empty() || scene.sky.radiance != glm::vec3(0.0f);
}

void append_surroundings_state(std::string& state, const Frame& frame, uint64_t frame_number) {
    const RenderScene& scene = frame.scene;
    const auto append_image = [&](const std::shared_ptr<const TextureAsset>& image) {
        append_state(state, image ? image->id : uint64_t(0));
    };
    append_image(scene.sky.image);
    append_state(state, scene.sky.radiance);
    append_state(state, scene.sky.rotation);
    append_state(state, scene.sky.lights.count);
    for (const LightProbe& probe : scene.probes) {
        append_image(probe.image);
        append_state(state, probe.intensity);
        append_state(state, probe.transform);
        append_state(state, probe.extent_m.value_or(glm::vec3(0.0f)));
        append_state(state, probe.blend_m);
        append_state(state, probe.lights.count);
    }
    if (frame.seams.providers(Seam::indirect_light).size() > 1) append_state(state, frame_number);
}

}  // namespace tyndall
