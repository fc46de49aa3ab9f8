#pragma once
// Materials of glTF files; included by the glTF sources alone.

#include <glm/mat3x3.hpp>
#include <map>
#include <memory>

#include "scene/gltf_textures.h"

namespace tyndall {

/// Linear Rec.709, in which glTF gives its factors, to the working space.
[[nodiscard]] glm::mat3 rec709_to_working(const ColorConfig& config);

/// The materials of a file, each made once.
class GltfMaterials {
 public:
    GltfMaterials(GltfFile& file, GltfTextures& textures, const glm::mat3& to_working, std::string name)
        : file_(file), textures_(textures), to_working_(to_working), name_(std::move(name)) {}

    /// A material by its index, or glTF's default one for -1. Throws Error.
    [[nodiscard]] std::shared_ptr<const Material> get(int material, std::string_view pointer);

 private:
    GltfFile& file_;
    GltfTextures& textures_;
    glm::mat3 to_working_;
    std::string name_;
    std::map<int, std::shared_ptr<const Material>> made_;
};

}  // namespace tyndall
