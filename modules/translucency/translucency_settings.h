#pragma once
/// What a scene may choose of the rendering of translucent things.

#include "ecs/description.h"

namespace tyndall::translucency {

/// A model of diffusion (physics/bssrdf.glsl).
enum class Model { normalised, better, standard, photon_beams, directional };
/// How much a model returns in all.
enum class Scaling { exact, published };

/// The technique points.
struct PointsSettings {
    int32_t levels = 15;
    float opening = 0.5f;
};

inline void describe(StructBuilder<PointsSettings>& d) {
    d.doc("Points on the surface that gather from all others, far ones in groups.");
    d.field("levels", &PointsSettings::levels, "2 to this power points an object.").range(6, 16);
    d.field("opening", &PointsSettings::opening,
            "Radius of a group over its distance, up to which it counts as one: less is slower and nearer to the full "
            "sum; 0 is the full sum.")
        .range(0.0, 2.0);
}

struct TranslucencySettings {
    static constexpr std::string_view kName = "translucency";
    bool enabled = true;
    Model model = Model::photon_beams;
    Scaling scaling = Scaling::exact;
    PointsSettings points;
};

inline void describe(StructBuilder<TranslucencySettings>& d) {
    using S = TranslucencySettings;
    d.doc("How surfaces with an interior that scatters are rendered.");
    d.field("enabled", &S::enabled, "Off: interiors are drawn plainly, by the light that a half-space returns.");
    d.field("model", &S::model, "The model of diffusion: where the light that enters leaves again.",
            {"normalised", "better", "standard", "photon_beams", "directional"});
    d.field("scaling", &S::scaling,
            "How much leaves in all: as much as a half-space returns (exact), or what the model says (published).",
            {"exact", "published"});
    d.field("points", &S::points, "The technique points.");
}

}  // namespace tyndall::translucency
