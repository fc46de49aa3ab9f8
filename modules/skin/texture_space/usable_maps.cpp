#include "texture_space/usable_maps.h"

#include "core/log.h"
#include "texture_space/atlas.h"

namespace tyndall::skin {

bool UsableMaps::usable(const MeshAsset& mesh, const std::string& name) {
    const auto found = known_.find(mesh.id);
    if (found != known_.end()) return found->second;
    constexpr int kSize = 256, kMost = 1000;
    const Atlas atlas = make_atlas(mesh.mesh, kSize);
    if (!atlas.usable())
        log::warning(
            "skin: {}: {}. It can't be done in texture space (six_gaussians, hable) and is done on the screen "
            "(separable)",
            name, atlas.problem);
    if (known_.size() >= kMost) known_.clear();  // meshes that have gone
    return known_[mesh.id] = atlas.usable();
}

}  // namespace tyndall::skin
