#include "scene/render_scene.h"

#include <atomic>

namespace tyndall {

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

}  // namespace tyndall
