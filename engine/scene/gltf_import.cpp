#include "scene/gltf_import.h"

#include "core/log.h"
#include "scene/gltf_materials.h"
#include "scene/gltf_meshes.h"
#include "scene/gltf_nodes.h"
#include "scene/gltf_textures.h"

namespace tyndall {

GltfAsset import_gltf(const std::filesystem::path& path, std::string_view name, const ColorConfig& config,
                      std::vector<std::filesystem::path>& sources) {
    GltfFile file = read_gltf(path, sources);
    GltfAsset asset{.id = new_asset_id(), .name = std::string(name)};
    const glm::mat3 to_working = rec709_to_working(config);
    GltfTextures textures(file, config, asset.name);
    GltfMaterials materials(file, textures, to_working, asset.name);
    GltfMeshes meshes(file, asset.name);
    for (const GltfPlace& place : order_nodes(file)) {
        GltfNode& node = asset.nodes.emplace_back(read_node(file, place, to_working));
        const int mesh = file.model.nodes[static_cast<size_t>(place.node)].mesh;
        if (mesh < 0) continue;
        const std::string pointer = "/nodes/" + std::to_string(place.node) + "/mesh";
        for (const GltfMeshes::Primitive& primitive : meshes.primitives(mesh, pointer))
            node.primitives.push_back({primitive.mesh, materials.get(primitive.material, pointer)});
    }
    if (!file.model.animations.empty()) file.warn("animations are ignored");
    textures.load();
    meshes.load();
    for (const std::string& warning : file.warnings) log::warning("{}: {}", path.string(), warning);
    asset.warnings = std::move(file.warnings);
    return asset;
}

}  // namespace tyndall
