#pragma once
/// glTF 2.0 files (.gltf and .glb) as the engine keeps them.

#include <filesystem>
#include <string_view>
#include <vector>

#include "scene/asset_store.h"

namespace tyndall {

/// Reads a glTF 2.0 file: the nodes of its scene, their meshes, materials with textures, cameras and lights. What else
/// it holds is named in the result's warnings. `sources` receives every file that was read, also when this throws.
/// Throws Error, with a JSON pointer into the file where one applies, for whatever is broken, lies outside the file's
/// folder, or is required and not supported.
[[nodiscard]] GltfAsset import_gltf(const std::filesystem::path& file, std::string_view name, const ColorConfig& config,
                                    std::vector<std::filesystem::path>& sources);

}  // namespace tyndall
