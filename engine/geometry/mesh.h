#pragma once
/// Triangle meshes as the renderer and the path tracer take them.

#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "geometry/bounds.h"

namespace tyndall {

/// Indexed triangles, an array for each attribute. An attribute is empty or as long as `positions`.
struct Mesh {
    std::vector<glm::vec3> positions;  ///< metres
    std::vector<glm::vec3> normals;    ///< unit length
    std::vector<glm::vec4> tangents;   ///< unit length, orthogonal to the normal; bitangent = w cross(normal, tangent)
    std::vector<glm::vec2> uv0;        ///< glTF's convention: (0, 0) is the picture's top left
    std::vector<glm::vec2> uv1;
    std::vector<float> curvatures;       ///< 1/m; made by compute_curvatures for what needs it
    std::vector<std::uint32_t> indices;  ///< three for each triangle, counter-clockwise from outside
    Bounds bounds;                       ///< of the positions

    [[nodiscard]] size_t triangle_count() const { return indices.size() / 3; }
};

/// The angle between faces beyond which an edge is hard where a file brings no normals: boxes keep their edges, and
/// scans stay smooth.
inline constexpr float kDefaultCrease = 80.0f * std::numbers::pi_v<float> / 180.0f;

/// Reads a model of the kinds OBJ, PLY, OFF and STL: polygons are cut into triangles; missing normals are made with
/// kDefaultCrease, and tangents as compute_tangents does. Throws Error with the file, and the line where known, for
/// what is missing, empty, truncated, corrupt, or names vertices that are not there.
[[nodiscard]] Mesh load_mesh(const std::filesystem::path& file);

/// Makes the normals anew: the mean of the faces around, weighted by their angle there (Thuermer and Wuethrich 1998).
/// Faces that meet at more than `crease` radians do not blend: vertices there are split. Vertices in the same place
/// count as one, so that UV seams do not show. A vertex without any proper face gets +Y.
void compute_normals(Mesh& mesh, float crease = std::numbers::pi_v<float>);

/// Makes the tangents anew from uv0 and the normals, the way MikkTSpace does: accumulated on the vertex' plane,
/// weighted by angle; vertices where mirrored parts of the picture meet are split. Where the UVs are missing or
/// degenerate, any tangent orthogonal to the normal. Throws Error when the mesh has no normals.
void compute_tangents(Mesh& mesh);

/// The bounds of the positions.
[[nodiscard]] Bounds bounds_of(const std::vector<glm::vec3>& positions);

/// Throws Error, naming `source`, when an attribute has another length than the positions, an index is out of range,
/// or a position is not finite.
void validate(const Mesh& mesh, const std::string& source);

}  // namespace tyndall
