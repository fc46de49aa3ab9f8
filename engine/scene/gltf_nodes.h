#pragma once
// Nodes, cameras and lights of glTF files; included by the glTF sources alone.

#include <glm/mat3x3.hpp>
#include <vector>

#include "scene/asset_store.h"
#include "scene/gltf_file.h"

namespace tyndall {

/// A node of the file's scene in the order that GltfAsset keeps: parents first.
struct GltfPlace {
    int node = 0;     ///< index in the file
    int parent = -1;  ///< index in the order
};

/// The nodes of the file's default scene (its first when none is named, all when it has none). Throws Error for cycles,
/// nodes with two parents and indices out of range.
[[nodiscard]] std::vector<GltfPlace> order_nodes(const GltfFile& file);

/// A node's placement, camera and light; its primitives are left empty. Throws Error.
[[nodiscard]] GltfNode read_node(GltfFile& file, const GltfPlace& place, const glm::mat3& to_working);

}  // namespace tyndall
