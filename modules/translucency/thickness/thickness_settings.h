#pragma once
/// What a scene may choose of the technique thickness.

#include "ecs/description.h"

namespace tyndall::translucency {

struct ThicknessSettings {
    float distortion = -1.0f;
    float power = -1.0f;
    float ambient = -1.0f;
    float scale = 1.0f;
};

inline void describe(StructBuilder<ThicknessSettings>& d) {
    d.doc("Light through the body by how thick it is about each place, and by the eye's direction: not physical.");
    d.field("distortion", &ThicknessSettings::distortion,
            "How far the normal turns the light that passes through; below 0: n / (1 + n) of a body n mean free paths "
            "in radius.")
        .range(-1.0, 4.0);
    d.field("power", &ThicknessSettings::power,
            "Narrows the light toward an eye that looks into the light; below 0: 1 + 4 / n.")
        .range(-1.0, 64.0);
    d.field("ambient", &ThicknessSettings::ambient,
            "Share of the light through the body that leaves whatever the direction; below 0: n / (1 + n).")
        .range(-1.0, 1.0);
    d.field("scale", &ThicknessSettings::scale, "Multiplies the light through the body; 1 is as much as enters.")
        .range(0.0, 100.0);
}

}  // namespace tyndall::translucency
