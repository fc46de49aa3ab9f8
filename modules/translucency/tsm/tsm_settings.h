#pragma once
/// What a scene may choose of the technique tsm.

#include "ecs/description.h"

namespace tyndall::translucency {

struct TsmSettings {
    int32_t size = 256;
    float finest = 0.25f;
};

inline void describe(StructBuilder<TsmSettings>& d) {
    d.doc("Translucent shadow maps: pixels gather from what each light sees, finely near by and coarsely far away.");
    d.field("size", &TsmSettings::size, "Texels on a side of a light's map of an object; rounded to a power of two.")
        .range(32, 2048);
    d.field("finest", &TsmSettings::finest,
            "How fine the map is looked at near by, in mean free paths: less is slower and follows the light more "
            "closely; 0 is the map's own texels.")
        .range(0.0, 8.0);
}

}  // namespace tyndall::translucency
