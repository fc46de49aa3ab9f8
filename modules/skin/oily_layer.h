#pragma once
/// How much light the oily layer takes and lets through.

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace tyndall::skin {

/// By cosine along a row and roughness from row to row, as physics/tables.h has them.
///  - x: of the light that the layer lets through, what enters at that angle over the mean of even light: what is not
///    mirrored on the way in is there for diffusion, and what is not mirrored on the way out is the compose pass's to
///    say. Over all angles of entry the mean is 1, so nothing is lost or gained (as in Ashikhmin & Shirley 2000).
///  - y: what the layer's lobes are dimmed by, at the eye's angle, so that they do not mirror more than the compose
///  pass
///    takes from diffuse light; 1 where they mirror less.
struct OilyLayer {
    static constexpr int kSize = 32;
    std::vector<glm::vec2> texels = std::vector<glm::vec2>(size_t(kSize) * kSize);
};

/// Of the material's shading parameters: roughness of both lobes over the surface's, share of the second, 1 = Kelemen &
/// Szirmay-Kalos.
[[nodiscard]] OilyLayer oily_layer(const glm::vec4& parameters);

}  // namespace tyndall::skin
