#pragma once
/// What the techniques of the light pass make of one light, as tables over the angle and the surface's curvature.

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "physics/diffusion_profile.h"
#include "physics/profile_corrections.h"

namespace tyndall::skin {

/// Rows of one curvature (from the flat one up), along a row the cosine between normal and light from -1 to 1. Exact in
/// both ends and at 0; shaders/shading_model.glsl looks it up.
struct Response {
    static constexpr int kCosines = 129;
    static constexpr int kCurvatures = 32;
    std::vector<glm::vec4> texels = std::vector<glm::vec4>(size_t(kCosines) * kCurvatures);

    /// Curvature of a row, 1/m, as the G-buffer encodes it; the last row stands for one that is large.
    [[nodiscard]] static float curvature_of(int row);
};

/// The clamped cosine.
[[nodiscard]] Response lambert_response();
/// Wrap lighting (Real-Time Rendering 14.6.1) whose width per channel is what the profile asks for on a sphere of that
/// curvature: it keeps the mean of light, and its first moment is 1 - <r^2> / 2 R^2, as diffusion's is
/// (Sloan et al. 2011, Wrap Shading: ((c + a) / (1 + a))^(1 + a) (2 + a) / 2 (1 + a), first moment 3 / (3 + a)).
[[nodiscard]] Response wrap_response(const physics::DiffusionProfile& profile);
/// Light diffused over a sphere of that curvature, lit from one side: the profile over chords, divided by its own
/// integral (Penner, Pre-Integrated Skin Shading, SIGGRAPH 2011 courses, who integrates over a ring).
[[nodiscard]] Response preintegrated_response(const physics::DiffusionProfile& profile);

/// The same with what the profile does not know, on a ball of each curvature: what entered at an angle leaves farther
/// from the light, there is more of it at grazing angles, and more the more curved the surface is.
[[nodiscard]] Response corrected(const Response& response, const physics::ProfileCorrections& corrections);

/// The light that a shadow's soft border leaves, once diffused: along a row the share of light from 0 to 1, rows by the
/// border's width (Penner 2011, shadow scattering). The edge stands in the border's middle and reaches as far as the
/// border does.
struct ShadowResponse {
    static constexpr int kShares = 65;
    static constexpr int kWidths = 32;
    /// Widest border, metres; row j has j / (kWidths - 1) of it.
    static constexpr float kWidest_m = 0.02f;
    std::vector<glm::vec4> texels = std::vector<glm::vec4>(size_t(kShares) * kWidths);
};
[[nodiscard]] ShadowResponse shadow_response(const physics::DiffusionProfile& profile);

}  // namespace tyndall::skin
