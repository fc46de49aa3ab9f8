#pragma once
/// Meshes of simple shapes, made instead of loaded.

#include "geometry/mesh.h"
#include "scene/components.h"

namespace tyndall {

/// The mesh of a shape in the box from -1/2 to 1/2, with normals, tangents and UVs: a sphere (UVs by longitude and
/// latitude) and a cylinder of `tessellation` (3..512) segments around +Y, a box, or a plane at y = 0 that faces +Y.
/// An empty mesh for Primitive::none.
[[nodiscard]] Mesh make_primitive(Primitive shape, int tessellation);

}  // namespace tyndall
