#pragma once
/// A surface laid out flat by its UVs: which place each texel of a map holds, and how far apart texels are.

#include <array>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "geometry/mesh.h"

namespace tyndall::skin {

/// How many texels a length on the surface covers, about a texel: a round Gaussian of standard deviation s metres is
/// one of s * along_u texels along u, and then one of s * along_v rows along the direction (lean, 1).
struct TexelSteps {
    float along_u = 0.0f;  ///< texels a metre
    float lean = 0.0f;     ///< columns a row
    float along_v = 0.0f;  ///< rows a metre
};

/// A texel whose middle lies in a triangle.
struct AtlasTexel {
    glm::vec3 position{0.0f};  ///< in the mesh's space
    glm::vec3 normal{0.0f};    ///< of the vertices, unit
    float curvature = 0.0f;    ///< of the mesh where it brings it, 1/m, 0 where it is hollow
    glm::vec3 face{0.0f};      ///< normal of the triangle, unit
    TexelSteps steps;
    float area = 0.0f;  ///< of the surface, m2
    glm::ivec2 at{0};   ///< column and row; rows go down, as v does
    uint32_t chart = 0;
};

/// A texel outside of a chart, which shows what lies across the chart's border.
struct GutterTexel {
    glm::ivec2 at{0};
    glm::vec2 source{0.0f};  ///< where that lies, texels from the map's corner
    TexelSteps steps;        ///< as inside of the border
    uint32_t chart = 0;      ///< the chart whose border it is at; 0 = it only pads an open one for bilinear lookups
    std::array<glm::ivec2, 4> taps{};  ///< covered texels that a bilinear lookup of the source is made of
    std::array<float, 4> weights{};    ///< of the taps; their sum is 1
};

/// Texels beyond a chart's border that show what lies across it; as many lie around the square of the UVs.
inline constexpr int kGutterTexels = 12;

/// The texels of a map for a mesh by its uv0.
struct Atlas {
    int size = 0;                      ///< texels on a side of the UVs' square
    glm::vec2 tile{0.0f};              ///< what is taken from the mesh's UVs: 0 but where they lie in another tile
    std::vector<AtlasTexel> texels;    ///< tile by tile
    std::vector<GutterTexel> gutters;  ///< those that pad come last
    size_t padding = 0;                ///< how many of them pad
    uint32_t charts = 0;
    float texel_m = 0.0f;  ///< side of a square texel of the mean area, metres
    float leaning = 0.0f;  ///< share of the texels with u and v further than 5 degrees from square
    float overlap = 0.0f;  ///< share of the covered texels that several triangles cover
    std::string problem;   ///< why the mesh can't be laid out, for people; empty = it is

    [[nodiscard]] bool usable() const { return problem.empty(); }
    /// Texels on a side of the map.
    [[nodiscard]] int extent() const { return size + 2 * kGutterTexels; }
    /// Where a place of the UVs is, texels from the map's corner.
    [[nodiscard]] glm::vec2 place(const glm::vec2& uv) const {
        return float(size) * (uv - tile) + float(kGutterTexels);
    }
    [[nodiscard]] size_t index(const glm::ivec2& at) const { return size_t(at.y) * size_t(extent()) + size_t(at.x); }
};

/// `shape` turns the mesh's positions into those whose lengths count in metres: the stretching part of a transform.
/// Gutters follow the surface across the seam's edge as if it were unfolded there.
[[nodiscard]] Atlas make_atlas(const Mesh& mesh, int size, const glm::mat3& shape = glm::mat3(1.0f));

}  // namespace tyndall::skin
