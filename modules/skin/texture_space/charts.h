#pragma once
/// The charts of a mesh's UVs, and which of their border edges are the same edge of the surface.

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/mesh.h"

namespace tyndall::skin {

/// An edge at which a chart ends.
struct ChartBorder {
    std::array<uint32_t, 2> vertices{};  ///< of the mesh, in the triangle's order
    uint32_t opposite = 0;               ///< the triangle's third vertex
    uint32_t chart = 0;
    int twin = -1;  ///< index of the border that lies in the same place of the surface; -1 = the surface ends here
};

/// Triangles that hang together in the UVs.
struct Charts {
    std::vector<uint32_t> of_triangle;  ///< number of the chart, from 1 on
    uint32_t count = 0;
    std::vector<ChartBorder> borders;
    std::vector<uint32_t> points;  ///< for each vertex a number that vertices share which agree in place and UV
};

/// Vertices less than a hundred-thousandth of the mesh's size apart are in the same place. Triangles without area in
/// the UVs belong to charts as others do.
[[nodiscard]] Charts find_charts(const Mesh& mesh);

}  // namespace tyndall::skin
