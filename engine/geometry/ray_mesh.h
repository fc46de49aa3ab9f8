#pragma once
/// A mesh's triangles for ray casts.

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

#include "geometry/mesh.h"

namespace tyndall {

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
