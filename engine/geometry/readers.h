#pragma once
// The readers behind load_polygons; for the sources of this floor. Each takes the whole content of a file; what they
// return is still to be validated. OBJ, OFF and PLY have readers of our own: OpenMesh 9's hang or crash on many broken
// files (they loop on failed reads and trust indices and counts), keep one normal for each vertex of an OBJ, and open
// the material files that it names.

#include <string>
#include <string_view>

#include "geometry/polygons.h"

namespace tyndall {

/// Wavefront OBJ: positions, texture coordinates, normals and faces; all else (materials, groups, curves) is passed
/// over. Throws Error with the line.
[[nodiscard]] PolygonMesh read_obj(std::string_view content, const std::string& source);

/// Text OFF, with normals (NOFF); colours are passed over. Throws Error with the line.
[[nodiscard]] PolygonMesh read_off(std::string_view content, const std::string& source);

/// PLY, text and binary: positions, normals, texture coordinates and faces; all else is passed over. Throws Error, with
/// the line where there are lines.
[[nodiscard]] PolygonMesh read_ply(std::string_view content, const std::string& source);

/// STL, text and binary, through OpenMesh: corners in the same place are joined. Throws Error.
[[nodiscard]] PolygonMesh read_stl(const std::string& content, const std::string& source);

}  // namespace tyndall
