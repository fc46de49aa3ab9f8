#pragma once
/// The authoring component `medium`: fog, dust, smoke, water or fire, and where it is.

#include <glm/vec3.hpp>

#include "medium_bounds.h"
#include "medium_optics.h"
#include "scene/extraction.h"
#include "scene/scattering_components.h"

namespace tyndall::participating_media {

/// What renders a medium: 0 = auto, otherwise a Solver, counted from 1.
enum class SolverChoice : int32_t { automatic };

/// A medium; overlapping media add. Single scattering is what this module renders of it.
struct MediumComponent {
    static constexpr std::string_view kName = "medium";
    BoundsChoice bounds;
    OpticsChoice optics;
    glm::vec3 scattering_per_m{0.1f};
    glm::vec3 absorption_per_m{0.01f};
    glm::vec3 emission_cd_m2_per_m{0.0f};
    BlackBody black_body;
    float scatter_factor = 1.0f;
    PhaseChoice phase;
    DensityChoice density;
    SolverChoice solver = SolverChoice::automatic;
};
void describe(StructBuilder<MediumComponent>& d);

/// Adds the component's Medium to the scene.
void extract_medium(const ExtractContext& context, const void* component, RenderScene& scene);

}  // namespace tyndall::participating_media
