#pragma once
/// What a scene may choose of the technique scatter_maps.

#include "ecs/description.h"

namespace tyndall::translucency {

/// How light inside is followed to where it entered.
enum class ScatterMapsForm { ki, hery, green };
/// Which light is rendered.
enum class ScatterMapsLight { all, once };
/// How form green takes light away with the thickness.
enum class ScatterMapsFalloff { exponential, ramp };

/// The technique scatter_maps.
struct ScatterMapsSettings {
    ScatterMapsForm form = ScatterMapsForm::ki;
    int32_t steps = 8;
    int32_t map_size = 256;
    ScatterMapsLight light = ScatterMapsLight::all;
    ScatterMapsFalloff falloff = ScatterMapsFalloff::exponential;
};

inline void describe(StructBuilder<ScatterMapsSettings>& d) {
    using S = ScatterMapsSettings;
    d.doc("Subsurface scatter maps: what each light sees of a solid says how far its light has come inside.");
    d.field("form", &S::form,
            "ki: light that scatters once is marched along the eye's refracted ray, and what scatters more often is "
            "blurred in the map; hery: a few places on that ray alone; green: the map's thickness at the pixel alone.",
            {"ki", "hery", "green"});
    d.field("steps", &S::steps, "ki: places on the eye's ray inside; hery takes half of them.").range(2, 32);
    d.field("map_size", &S::map_size, "Texels of a light's map of an object along each side.").range(32, 2048);
    d.field("light", &S::light, "all; or once: only what scatters once, to compare with traced light.",
            {"all", "once"});
    d.field("falloff", &S::falloff,
            "green only: how light fades with the thickness: by the exponential of diffusion, or straight down to none "
            "at twice its length.",
            {"exponential", "ramp"});
}

}  // namespace tyndall::translucency
