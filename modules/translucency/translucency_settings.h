#pragma once
/// What a scene may choose of the rendering of translucent things.

#include "ecs/description.h"
#include "radiance_maps/radiance_maps_settings.h"
#include "scatter_maps/scatter_maps_settings.h"
#include "thickness/thickness_settings.h"
#include "tsm/tsm_settings.h"

namespace tyndall::translucency {

/// A model of diffusion (physics/bssrdf.glsl).
enum class Model { normalised, better, standard, photon_beams, directional };
/// How much a model returns in all.
enum class Scaling { exact, published };

/// The technique points.
struct PointsSettings {
    int32_t levels = 15;
    float pixels = 4.0f;
    int32_t most = 131072;
    float opening = 0.5f;
    bool interreflection = true;
};

inline void describe(StructBuilder<PointsSettings>& d) {
    d.doc("Points on the surface that gather from all others, far ones in groups.");
    d.field("levels", &PointsSettings::levels, "2 to this power points an object at most.").range(6, 16);
    d.field("pixels", &PointsSettings::pixels,
            "No points closer together than so many pixels: far objects have fewer; 0: all have as many as levels "
            "says.")
        .range(0.0, 64.0);
    d.field("most", &PointsSettings::most, "Points of all objects in view together; beyond that all have fewer.")
        .range(1024, 16777216);
    d.field("opening", &PointsSettings::opening,
            "Radius of a group over its distance, up to which it counts as one: less is slower and nearer to the full "
            "sum; 0 is the full sum.")
        .range(0.0, 2.0);
    d.field("interreflection", &PointsSettings::interreflection,
            "Light that leaves the body and meets it again, and what the body hides of light from all around.");
}

/// How the technique htsm weights its rays.
enum class HtsmForm { physical, shopf };

/// From where the rays toward the light are marched.
enum class HtsmMarch { voxels, pixels };

/// The technique htsm.
struct HtsmSettings {
    int32_t rays = 9;
    int32_t steps = 16;
    int32_t resolution = 64;
    HtsmForm form = HtsmForm::physical;
    HtsmMarch march = HtsmMarch::voxels;
    float transport_distance_m = 0.0f;
};

inline void describe(StructBuilder<HtsmSettings>& d) {
    d.doc("Heterogeneous translucent shadow maps: rays through a grid of the density to where the light entered.");
    d.field("rays", &HtsmSettings::rays, "Rays a pixel and light: 1, 5, 9 or 13; others count as the next of these.")
        .range(1, 13);
    d.field("steps", &HtsmSettings::steps, "Places at which a ray looks at the density.").range(1, 256);
    d.field("resolution", &HtsmSettings::resolution, "Voxels of the grid along the object's longest side.")
        .range(8, 256);
    d.field("form", &HtsmSettings::form,
            "physical: single scattering, by the optical depth of both parts of the way; shopf: the formula of the "
            "paper, by lengths.",
            {"physical", "shopf"});
    d.field(
        "march", &HtsmSettings::march,
        "physical only: where rays toward the light begin: at every voxel, kept while nothing changes and shared by "
        "all pixels; or anew for each pixel, which is slower and sharper.",
        {"voxels", "pixels"});
    d.field("transport_distance_m", &HtsmSettings::transport_distance_m,
            "shopf only: half the way after which no light is left; 0 takes it from the coefficients.")
        .unit("m")
        .range(0.0, 1e6);
}

struct TranslucencySettings {
    static constexpr std::string_view kName = "translucency";
    bool enabled = true;
    Model model = Model::photon_beams;
    Scaling scaling = Scaling::exact;
    PointsSettings points;
    HtsmSettings htsm;
    TsmSettings tsm;
    ThicknessSettings thickness;
    RadianceMapsSettings radiance_maps;
    ScatterMapsSettings scatter_maps;
};

inline void describe(StructBuilder<TranslucencySettings>& d) {
    using S = TranslucencySettings;
    d.doc("How surfaces with an interior that scatters are rendered.");
    d.field(
        "enabled", &S::enabled,
        "Off: interiors are drawn plainly, by the light that a half-space returns, and leaves let nothing through.");
    d.field("model", &S::model, "The model of diffusion: where the light that enters leaves again.",
            {"normalised", "better", "standard", "photon_beams", "directional"});
    d.field("scaling", &S::scaling,
            "How much leaves in all: as much as a half-space returns (exact), or what the model says (published).",
            {"exact", "published"});
    d.field("points", &S::points, "The technique points.");
    d.field("htsm", &S::htsm, "The technique htsm.");
    d.field("tsm", &S::tsm, "The technique tsm.");
    d.field("thickness", &S::thickness, "The technique thickness.");
    d.field("radiance_maps", &S::radiance_maps, "The technique radiance_maps.");
    d.field("scatter_maps", &S::scatter_maps, "The technique scatter_maps.");
}

}  // namespace tyndall::translucency
