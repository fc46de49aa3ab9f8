#pragma once
/// Tables that shaders look up and C++ computes.

#include <array>
#include <glm/glm.hpp>

namespace tyndall::physics {

/// Directional albedo of the GGX lobe over angle and roughness: x for (F0, F90) = (1, 0), y for (0, 1); their sum is
/// the albedo of a perfect mirror's single bounce. Upload as RG32F (half floats would cost 2e-4), linear filter,
/// clamped; `standard_table_coordinate` says where to look. Within 0.004 of the integrals for NoV >= 0.05, on the side
/// that never gains light.
struct SpecularTable {
    static constexpr int kSize = 32;
    std::array<glm::vec2, kSize * kSize> texels;  ///< rows of equal roughness

    /// What the GPU's linear filter returns.
    [[nodiscard]] glm::vec2 sample(float nov, float roughness) const;
};

/// Directional albedo pair by quadrature over `steps` * `steps` visible normals; 32 steps are good to 1e-3.
[[nodiscard]] glm::vec2 ggx_directional_albedo(float nov, float roughness, int steps);

/// Computes the table: about 50 ms.
[[nodiscard]] SpecularTable make_specular_table();

}  // namespace tyndall::physics
