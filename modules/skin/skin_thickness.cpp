#include "skin_thickness.h"

#include <chrono>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>

#include "core/log.h"
#include "geometry/thickness.h"
#include "texture_space/surface_maps.h"

namespace tyndall::skin {
namespace {

/// Baked meshes kept, those that have gone among them.
constexpr size_t kMostBaked = 64;

/// What thickness needs of a mesh, as `shape` makes it.
Mesh stretched(const Mesh& mesh, const glm::mat3& shape) {
    Mesh result;
    const glm::mat3 normal_matrix = glm::inverseTranspose(shape);
    for (const glm::vec3& position : mesh.positions) result.positions.push_back(shape * position);
    for (const glm::vec3& normal : mesh.normals) {
        const glm::vec3 turned = normal_matrix * normal;
        const float length = glm::length(turned);
        result.normals.push_back(length > 0.0f ? turned / length : normal);
    }
    result.indices = mesh.indices;
    result.bounds = bounds_of(result.positions);
    return result;
}

}  // namespace

std::shared_ptr<const SurfaceThickness> Thicknesses::of(const SkinComponent& component, const Surface& surface,
                                                        AssetStore& assets) {
    const bool has_map = !component.maps.thickness.empty();
    if (!has_map && component.thickness == ThicknessUse::given) return nullptr;
    auto made = std::make_shared<SurfaceThickness>();
    made->all_lights = component.thickness == ThicknessUse::all;
    if (has_map) {
        made->map.texture = assets.texture(component.maps.thickness, TextureUse::data);
        made->map_m = component.thickness_mm * 1e-3f;
        return made;
    }
    made->vertices = baked(surface);
    return made->vertices.empty() ? nullptr : made;
}

const std::vector<float>& Thicknesses::baked(const Surface& surface) {
    const Stretch stretch = stretch_of(surface.transform);
    const Key key{surface.mesh->id, stretch.key};
    if (const auto found = baked_.find(key); found != baked_.end()) return found->second;
    if (baked_.size() >= kMostBaked) baked_.clear();
    const auto begun = std::chrono::steady_clock::now();
    std::vector<float>& made = baked_[key] = vertex_thicknesses(stretched(surface.mesh->mesh, stretch.shape));
    log::info("skin: {}: thickness of {} vertices, {:.2f} s", surface.mesh->name, made.size(),
              std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count());
    return made;
}

}  // namespace tyndall::skin
