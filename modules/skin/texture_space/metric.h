#pragma once
/// How a surface is stretched on its way to a map.

#include <glm/mat2x2.hpp>
#include <glm/mat3x3.hpp>
#include <vector>

#include "texture_space/atlas.h"
#include "texture_space/charts.h"

namespace tyndall::skin {

/// The first fundamental form for a map of some size: the squared length of a step d of texels is dot(d, g d); m2.
struct Metric {
    float uu = 0.0f, uv = 0.0f, vv = 0.0f;
    [[nodiscard]] glm::mat2 matrix() const { return {{uu, uv}, {uv, vv}}; }
    [[nodiscard]] float determinant() const { return uu * vv - uv * uv; }
};

/// At the vertices: means over the triangles around in the same chart, by their angles in the map:
/// the way a quad is cut doesn't count.
[[nodiscard]] std::vector<Metric> vertex_metrics(const Mesh& mesh, const Charts& charts, int size,
                                                 const glm::mat3& shape);
[[nodiscard]] Metric mix(const Metric& a, const Metric& b, float share);
[[nodiscard]] TexelSteps steps_of(const Metric& metric);

}  // namespace tyndall::skin
