#pragma once
/// Which meshes can be laid out for texture space.

#include <cstdint>
#include <map>
#include <string>

#include "scene/render_scene.h"

namespace tyndall::skin {

/// Looks at each mesh once.
class UsableMaps {
 public:
    /// Whether light can be spread in a map of the mesh's. Why it can't be is logged once, with `name` of the surface.
    bool usable(const MeshAsset& mesh, const std::string& name);

 private:
    std::map<uint64_t, bool> known_;  ///< by mesh
};

}  // namespace tyndall::skin
