#pragma once
/// A mesh as the maps draw it.

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "geometry/mesh.h"
#include "gpu/gpu.h"

namespace tyndall::translucency {

/// How a camera far away, or one at a place, sees an object: a square map.
struct MapView {
    glm::mat4 clip_from_body{1.0f};  ///< reversed depth
    glm::vec3 eye{0.0f};
    bool perspective = false;
    glm::vec3 axis{0.0f, 0.0f, -1.0f};  ///< unit, along which it looks
    float side = 1.0f;                  ///< of the map, in the body's unit; in perspective at distance 1
};

/// Fitted to the places, with a border of `texels` of `resolution` around; looks along the unit vector `axis`.
[[nodiscard]] MapView parallel_view(std::span<const glm::vec3> places, const glm::vec3& axis, int resolution);
/// From `eye`, which is outside of the sphere.
[[nodiscard]] MapView perspective_view(const glm::vec3& eye, const glm::vec3& middle, float radius);
/// Face 0..5 of a cube around `eye`, for eyes near by or inside.
[[nodiscard]] MapView cube_view(const glm::vec3& eye, int face, float radius);

/// Triangles on the GPU: attribute 0 the place, 1 the normal, 2 to 5 what objects have of their own at each vertex.
class BodyMesh {
 public:
    explicit BodyMesh(const Mesh& mesh);
    ~BodyMesh();
    BodyMesh(const BodyMesh&) = delete;
    BodyMesh& operator=(const BodyMesh&) = delete;

    /// With the program in use and the state as it is.
    void draw(const gpu::Buffer& own) const;
    [[nodiscard]] size_t bytes() const { return vertices_.size() + indices_.size(); }

 private:
    gpu::Buffer vertices_, indices_;
    int index_count_ = 0;
    unsigned int vertex_array_ = 0;
};

}  // namespace tyndall::translucency
