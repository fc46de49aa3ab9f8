#pragma once
/// The scene's triangles behind Embree, and what is known where a ray meets them.

#include <embree3/rtcore.h>

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "scene/render_scene.h"

namespace tyndall::reference {

struct Ray {
    glm::vec3 origin{0.0f};
    glm::vec3 direction{0.0f, 0.0f, -1.0f};  ///< unit
    float far_m = std::numeric_limits<float>::infinity();
};

/// What a ray can meet. A surface may be several.
enum class RayMask : uint32_t {
    blocking = 1,    ///< nothing of a shadow ray passes: opaque, or a boundary that bends light
    passing = 2,     ///< some light passes straight: index-matched boundaries, alpha, thin glass
    shadowless = 4,  ///< opaque, but passed by the shadow rays of lights without size: an artist's choice
    all = 7
};

struct Hit {
    float distance_m = 0.0f;
    uint32_t surface = 0;   ///< index in RenderScene::surfaces
    uint32_t triangle = 0;  ///< of its mesh
    glm::vec2 barycentric{0.0f};
};

/// A point on a surface, as materials need it. Directions are unit vectors in the world.
struct SurfacePoint {
    glm::vec3 position{0.0f};
    glm::vec3 geometric_normal{0.0f, 1.0f, 0.0f};  ///< outward: of the triangle's counter-clockwise side
    glm::vec3 normal{0.0f, 1.0f, 0.0f};            ///< interpolated, on the same side
    glm::vec4 tangent{0.0f};                       ///< w = handedness; zero when the mesh has none
    glm::vec2 uv[2] = {glm::vec2(0.0f), glm::vec2(0.0f)};
};

/// See the file's head. All triangles lie in the world; the scene's meshes must outlive this.
class Geometry {
 public:
    /// `masks` has a RayMask for each surface. Throws Error when there is no memory for it.
    Geometry(const std::vector<Surface>& surfaces, const std::vector<RayMask>& masks);
    ~Geometry();
    Geometry(const Geometry&) = delete;
    Geometry& operator=(const Geometry&) = delete;

    /// The nearest hit before ray.far_m.
    [[nodiscard]] bool intersect(const Ray& ray, RayMask mask, Hit& hit) const;
    [[nodiscard]] bool occluded(const Ray& ray, RayMask mask) const;
    [[nodiscard]] SurfacePoint point(const Hit& hit) const;
    /// Position and geometric normal alone, for boundaries that are only passed.
    [[nodiscard]] SurfacePoint flat_point(const Hit& hit) const;
    /// Area in m2 and the corners of a triangle in the world.
    [[nodiscard]] float area(uint32_t surface, uint32_t triangle) const;
    [[nodiscard]] SurfacePoint point_on(uint32_t surface, uint32_t triangle, glm::vec2 barycentric) const;
    /// Of all triangles; empty without any.
    [[nodiscard]] const Bounds& bounds() const { return bounds_; }

 private:
    struct Placed {
        const Mesh* mesh = nullptr;
        std::vector<glm::vec3> positions;  ///< in the world
        glm::mat3 normal_matrix{1.0f};
        glm::mat3 tangent_matrix{1.0f};
        float side = 1.0f;  ///< -1 when the transform mirrors
    };
    void corners(uint32_t surface, uint32_t triangle, glm::vec3 out[3]) const;

    RTCDevice device_ = nullptr;
    RTCScene scene_ = nullptr;
    std::vector<Placed> placed_;
    Bounds bounds_;
};

/// Where a ray that leaves `point` toward the side of `direction` starts, so that it does not meet its own surface
/// again (Waechter & Binder, "A Fast and Robust Method for Avoiding Self-Intersection", 2019).
[[nodiscard]] glm::vec3 offset_origin(const SurfacePoint& point, const glm::vec3& direction);

}  // namespace tyndall::reference
