#pragma once
/// Light that fog around a lamp sends onto a surface, as a table (Sun et al. 2005, 5.2).

#include <cstddef>
#include <vector>

namespace tyndall::participating_media {

/// The integrals over a surface's hemisphere, times exp(T), as shaders/analytic/surface_glow.glsl reads them: x over
/// the optical distance T to the lamp, y over the angle between the lamp and the surface's normal (layer 0) or its
/// mirror direction (further layers, a roughness each).
struct GlowTable {
    static constexpr int kDistances = 64, kAngles = 32, kLayers = 7;
    static constexpr float kLeastDepth = 1e-3f, kMostDepth = 30.0f, kLeastRoughness = 0.2f;
    std::vector<float> values;  ///< kLayers of kAngles rows
    [[nodiscard]] float at(int layer, int angle, int distance) const {
        return values[static_cast<size_t>((layer * kAngles + angle) * kDistances + distance)];
    }
};
[[nodiscard]] GlowTable make_glow_table();

/// Exponent of the Phong lobe about the mirror direction that is as wide as GGX of this roughness about its half
/// vectors.
[[nodiscard]] double phong_exponent(double roughness);

}  // namespace tyndall::participating_media
