#pragma once
/// Which surfaces of a scene are skin, and how they are rendered.

#include <cstddef>
#include <string>
#include <vector>

#include "scene/render_scene.h"

namespace tyndall::skin {

/// In the light pass: lambert .. preintegrated. On the screen: two_gaussians .. disc. In the map: six_gaussians, hable.
enum class Technique {
    lambert,
    wrap,
    blurred_normals,
    preintegrated,
    two_gaussians,
    separable,
    disc,
    six_gaussians,
    hable
};
/// Names of the techniques as scenes have them, in their order.
[[nodiscard]] const std::vector<std::string>& technique_names();
/// The technique of a surface that has diffusion; separable for names that are not this module's.
[[nodiscard]] Technique technique_of(const SurfaceDiffusion& diffusion);

/// Whether a surface's transform keeps it a body: not flat, and finite.
[[nodiscard]] bool has_volume(const Surface& surface);
/// What the body's thickness is used for, as shaders/surfaces.glsl has it: 0 = nothing, 1 = light without shadow maps,
/// 2 = all light through it.
[[nodiscard]] float thickness_use(const SurfaceDiffusion& diffusion);
/// Whether base colour counts where light enters, of a technique on the screen. Even colour cancels out.
[[nodiscard]] bool scatters_colour(const Surface& surface);

/// Indices of the scene's surfaces that are rendered with a technique.
[[nodiscard]] std::vector<size_t> surfaces_of(const RenderScene& scene, Technique technique);

}  // namespace tyndall::skin
