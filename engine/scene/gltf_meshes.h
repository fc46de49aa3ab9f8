#pragma once
// Primitives of glTF meshes; included by the glTF sources alone.

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "scene/gltf_file.h"
#include "scene/render_scene.h"

namespace tyndall {

/// The primitives of a file's meshes, each made once however many nodes show it.
class GltfMeshes {
 public:
    GltfMeshes(GltfFile& file, std::string name) : file_(file), name_(std::move(name)) {}

    struct Primitive {
        std::shared_ptr<const MeshAsset> mesh;  ///< empty until load()
        int material = -1;                      ///< index in the file, or -1 for the default one
    };
    /// The primitives of a mesh that have triangles; a warning tells of others. Throws Error.
    [[nodiscard]] const std::vector<Primitive>& primitives(int mesh, std::string_view pointer);
    /// Reads everything that was asked for, on all cores. Throws Error.
    void load();

 private:
    struct Job {
        const tinygltf::Primitive* primitive;
        std::string pointer;
        std::shared_ptr<MeshAsset> mesh;
    };
    void add(const tinygltf::Primitive& primitive, std::string pointer, std::vector<Primitive>& list,
             const std::string& name);
    void read(const Job& job) const;

    GltfFile& file_;
    std::string name_;
    std::map<int, std::vector<Primitive>> meshes_;
    std::vector<Job> jobs_;
    size_t elements_ = 0;  ///< vertices and indices so far
};

}  // namespace tyndall
