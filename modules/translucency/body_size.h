#pragma once
/// How large a solid is to light that wanders in it.

#include <array>
#include <glm/mat3x3.hpp>

#include "geometry/mesh.h"
#include "radial_kernel.h"

namespace tyndall::translucency {

/// The radius of the sphere with the volume over surface of what the turned and stretched mesh encloses: 3 V / A. 0
/// when its faces do not close (but for small holes, as scans have them), or have no area.
[[nodiscard]] float body_radius(const Mesh& mesh, const glm::mat3& world_from_local);

/// How much surface lies about the places of a body, over what flat ground has, by the distance in a straight line. A
/// kernel made for flat ground loses what it would put beyond a body's end (of a sphere, beyond its diameter: nearer, a
/// sphere has as much surface as flat ground), and gives more than there is to a sheet, whose other side is near, too.
class SurfaceDensity {
 public:
    SurfaceDensity() = default;
    /// In metres. Flat ground where the mesh has no area.
    SurfaceDensity(const Mesh& mesh, const glm::mat3& world_from_local);
    /// What a body sends out of a unit of light that has entered, in the mean over its surface; flat ground: 1.
    [[nodiscard]] glm::vec3 sent_out(const RadialKernel& kernel) const;

 private:
    static constexpr size_t kRings = 48;
    std::array<float, kRings + 1> ends_{};  ///< metres
    std::array<float, kRings> density_{};
};

/// Tells whether a placed mesh has another shape than before; turning does not change it.
class BodyShape {
 public:
    bool update(const glm::mat3& world_from_local);

 private:
    glm::mat3 metric_{0.0f};
};

/// A body's radius until its shape changes.
struct BodyRadius {
    float radius = 0.0f;  ///< body_radius

    /// True when the shape is another than before.
    bool update(const Mesh& mesh, const glm::mat3& world_from_local);

 private:
    BodyShape shape_;
};

/// All that is known of a body's size until its shape changes.
struct BodySize {
    float radius = 0.0f;  ///< body_radius
    SurfaceDensity surface;

    /// True when the shape is another than before.
    bool update(const Mesh& mesh, const glm::mat3& world_from_local);

 private:
    BodyShape shape_;
};

}  // namespace tyndall::translucency
