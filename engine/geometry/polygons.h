#pragma once
/// Meshes of polygons with any number of corners, as modelling programs write them: what subdivision starts from.

#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "geometry/mesh.h"

namespace tyndall {

/// Faces over shared positions. UVs and normals belong to the corners of faces: the two sides of a seam differ.
struct PolygonMesh {
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> face_sizes;  ///< corners of each face, at least 3
    std::vector<std::uint32_t> corners;     ///< of all faces, one after the other: indices of positions
    std::vector<glm::vec2> uvs;             ///< glTF's convention, (0, 0) is the top left
    std::vector<std::uint32_t> uv_corners;  ///< indices of uvs, as many as corners; or empty
    std::vector<glm::vec3> normals;
    std::vector<std::uint32_t> normal_corners;  ///< indices of normals, as many as corners; or empty
    std::vector<float> radii;                   ///< one for each position, for clouds of balls; or empty
};

/// Reads an OBJ, PLY, OFF or STL file as it is. Throws Error as load_mesh does.
[[nodiscard]] PolygonMesh load_polygons(const std::filesystem::path& file);

/// Cuts the faces into triangles (concave ones by ear clipping) and gives every different corner a vertex. Attributes
/// that the polygons do not have stay empty. Throws Error, naming `source`, for indices out of range, faces of fewer
/// than 3 corners and values that are not finite.
[[nodiscard]] Mesh triangulate(const PolygonMesh& polygons, const std::string& source = "mesh");

/// Throws Error as triangulate does.
void validate(const PolygonMesh& polygons, const std::string& source);

}  // namespace tyndall
