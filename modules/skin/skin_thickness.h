#pragma once
/// The thickness of bodies of skin, for light that comes through them.

#include <array>
#include <map>
#include <memory>
#include <utility>

#include "scene/asset_store.h"
#include "skin_component.h"

namespace tyndall::skin {

/// Keeps what has been baked.
class Thicknesses {
 public:
    /// As the component wants it: by its map, or baked from the mesh (0.1 to 0.5 s, once a mesh and its stretch); null
    /// when there is none. Throws Error when the map cannot be loaded.
    [[nodiscard]] std::shared_ptr<const SurfaceThickness> of(const SkinComponent& component, const Surface& surface,
                                                             AssetStore& assets);

 private:
    using Key = std::pair<uint64_t, std::array<int, 6>>;  ///< mesh, stretch
    [[nodiscard]] const std::vector<float>& baked(const Surface& surface);

    std::map<Key, std::vector<float>> baked_;
};

}  // namespace tyndall::skin
