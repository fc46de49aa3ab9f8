#pragma once
/// The authoring component `medium`: fog, dust, smoke or water in a box or in the whole scene.

#include <glm/vec3.hpp>
#include <variant>

#include "scene/extraction.h"

namespace tyndall::participating_media {

struct BoxBounds {};
struct WholeSceneBounds {};

struct IsotropicPhase {};
struct RayleighPhase {};
struct HenyeyGreensteinPhase {
    float g = 0.6f;
};
struct SchlickPhase {
    float g = 0.6f;
};
struct CornetteShanksPhase {
    float g = 0.6f;
};
struct TwoLobePhase {
    float g0 = 0.8f;
    float g1 = -0.3f;
    float weight = 0.3f;
};
struct WaterDropletPhase {
    float diameter_um = 20.0f;
};

void describe(StructBuilder<BoxBounds>& d);
void describe(StructBuilder<WholeSceneBounds>& d);
void describe(StructBuilder<IsotropicPhase>& d);
void describe(StructBuilder<RayleighPhase>& d);
void describe(StructBuilder<HenyeyGreensteinPhase>& d);
void describe(StructBuilder<SchlickPhase>& d);
void describe(StructBuilder<CornetteShanksPhase>& d);
void describe(StructBuilder<TwoLobePhase>& d);
void describe(StructBuilder<WaterDropletPhase>& d);

/// A homogeneous medium; overlapping media add. Single scattering is what this module renders of it.
struct MediumComponent {
    static constexpr std::string_view kName = "medium";
    std::variant<BoxBounds, WholeSceneBounds> bounds;
    glm::vec3 scattering_per_m{0.1f};
    glm::vec3 absorption_per_m{0.01f};
    std::variant<IsotropicPhase, HenyeyGreensteinPhase, SchlickPhase, RayleighPhase, CornetteShanksPhase, TwoLobePhase,
                 WaterDropletPhase>
        phase;
};
void describe(StructBuilder<MediumComponent>& d);

/// Adds the component's Medium to the scene.
void extract_medium(const ExtractContext& context, const void* component, RenderScene& scene);

}  // namespace tyndall::participating_media
