#include "scene/render_scene.h"

#include <atomic>
#include <glm/gtc/matrix_transform.hpp>

namespace tyndall {
namespace {

Bounds scene_bounds(const RenderScene& scene) {
    Bounds bounds;
    for (const Surface& surface : scene.surfaces) bounds.merge(surface.bounds);
    for (const Light& light : scene.lights)
        if (light.kind != LightKind::directional) bounds.add(glm::vec3(light.transform[3]));
    bounds.add(glm::vec3(scene.camera.transform[3]));
    return bounds;
}

}  // namespace

uint64_t new_asset_id() {
    static std::atomic<uint64_t> last{0};
    return ++last;
}

void RenderScene::clear() {
    camera = {};
    sky = {};
    cameras.clear();
    surfaces.clear();
    lights.clear();
    media.clear();
    probes.clear();
}

glm::mat4 medium_box(const Medium& medium, const RenderScene& scene) {
    if (medium.shape == MediumShape::box || medium.shape == MediumShape::ellipsoid) return medium.transform;
    Bounds bounds = scene_bounds(scene);
    if (medium.shape == MediumShape::layer) {
        bounds.low.y = medium.layer_low_m;
        bounds.high.y = medium.layer_high_m;
        if (!(bounds.low.y < bounds.high.y)) return glm::mat4(0.0f);
    }
    const glm::vec3 size = glm::max(bounds.high - bounds.low, glm::vec3(1e-3f));
    return glm::scale(glm::translate(glm::mat4(1.0f), 0.5f * (bounds.low + bounds.high)), size);
}

}  // namespace tyndall
