#pragma once
/// What a scene may choose of the technique radiance_maps.

#include "ecs/description.h"

namespace tyndall::translucency {

struct RadianceMapsSettings {
    int32_t views = 16;
    int32_t resolution = 256;
    int32_t light_resolution = 256;
    int32_t samples = 16;
    int32_t frames = 60;
};

inline void describe(StructBuilder<RadianceMapsSettings>& d) {
    using S = RadianceMapsSettings;
    d.doc("Maps of the light that leaves an object, seen from all around, gathered over some frames.");
    d.field("views", &S::views, "Directions from which maps see the object.").range(4, 64);
    d.field("resolution", &S::resolution, "Texels along a side of each of these maps.").range(32, 1024);
    d.field("light_resolution", &S::light_resolution, "Texels along a side of the map of what a light sees.")
        .range(32, 2048);
    d.field("samples", &S::samples, "Places a texel gathers from in a frame, shared among the lights.").range(1, 256);
    d.field("frames", &S::frames, "Frames over which light is gathered; then nothing is done until something changes.")
        .range(1, 1000);
}

}  // namespace tyndall::translucency
