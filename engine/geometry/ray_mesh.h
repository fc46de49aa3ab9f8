#pragma once
/// A mesh's triangles for ray casts.

#include <glm/mat3x3.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/mesh.h"

namespace tyndall {

/// `count` unit vectors spread as the cosine to +Z is, evenly by a golden spiral.
[[nodiscard]] std::vector<glm::vec3> cosine_directions(int count);

/// Turns +Z to the unit vector `normal`, and all about it by `turn` radians.
[[nodiscard]] glm::mat3 frame_about(const glm::vec3& normal, float turn);

/// Any thread may cast rays. Lengths are of the mesh's own space.
class RayMesh {
 public:
    struct Hit {
        float distance = 0.0f;
        bool front = false;  ///< the ray came from where the triangle is seen counterclockwise
    };

    explicit RayMesh(const Mesh& mesh);
    ~RayMesh();
    RayMesh(const RayMesh&) = delete;
    RayMesh& operator=(const RayMesh&) = delete;

    /// The first triangle nearer than `farthest` along a unit direction.
    [[nodiscard]] std::optional<Hit> cast(const glm::vec3& from, const glm::vec3& direction,
                                          float farthest = std::numeric_limits<float>::infinity()) const;

 private:
    struct Scene;
    std::unique_ptr<Scene> scene_;
};

}  // namespace tyndall
