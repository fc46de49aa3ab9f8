#pragma once
/// Where a medium is: the choices that the component `medium` has, and what they become.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scene/components.h"
#include "scene/extraction.h"

namespace tyndall::participating_media {

struct BoxBounds {};
struct WholeSceneBounds {};
struct EllipsoidBounds {};
struct LayerBounds {
    float base_m = 0.0f;
    float scale_height_m = 10.0f;
    float top_m = 0.0f;
};
/// The inside of a closed mesh, on voxels.
struct MeshBounds {
    std::string file;
    Primitive primitive = Primitive::none;
    int32_t resolution = 64;
};
struct ParticleChoice {
    glm::vec3 centre{0.0f};
    float radius_m = 0.1f;
    float weight = 1.0f;
};
struct ParticleBounds {
    std::string file;
    float radius_m = 0.1f;
    int32_t resolution = 64;
    std::vector<ParticleChoice> particles;
};

void describe(StructBuilder<BoxBounds>& d);
void describe(StructBuilder<WholeSceneBounds>& d);
void describe(StructBuilder<EllipsoidBounds>& d);
void describe(StructBuilder<LayerBounds>& d);
void describe(StructBuilder<MeshBounds>& d);
void describe(StructBuilder<ParticleChoice>& d);
void describe(StructBuilder<ParticleBounds>& d);

using BoundsChoice =
    std::variant<BoxBounds, WholeSceneBounds, EllipsoidBounds, LayerBounds, MeshBounds, ParticleBounds>;
/// The alternatives' names in scene files, in their order.
[[nodiscard]] std::vector<std::string> bounds_names();

/// What bounds make of a medium, but for the density inside.
struct PlacedBounds {
    MediumShape shape = MediumShape::box;
    glm::mat4 transform{1.0f};
    float low_m = 0.0f, high_m = 0.0f;   ///< of a layer
    std::optional<GridDensity> mask;     ///< where it is in the box
    std::optional<HeightDensity> layer;  ///< how it thins
    [[nodiscard]] bool whole() const { return shape == MediumShape::whole_scene || shape == MediumShape::layer; }
};
/// Throws Error for bounds without a volume, and for meshes and particles that cannot be loaded or have no inside.
[[nodiscard]] PlacedBounds place_bounds(const BoundsChoice& choice, const ExtractContext& context);

}  // namespace tyndall::participating_media
