#pragma once
/// What a scene may choose of the rendering of media.

#include "ecs/description.h"

namespace tyndall::participating_media {

enum class Resolution { full, half };

/// Polygonal light volumes.
struct LightVolumesSettings {
    int32_t texels_per_quad = 2;
    bool adaptive = true;
    float tolerance_m = 0.01f;
    int32_t terms = 8;
};

inline void describe(StructBuilder<LightVolumesSettings>& d) {
    d.doc("Polygonal light volumes: the border of the light as a mesh made from the shadow map.");
    d.field("texels_per_quad", &LightVolumesSettings::texels_per_quad,
            "Shadow-map texels along a side of the mesh's finest quads.")
        .range(1, 64);
    d.field("adaptive", &LightVolumesSettings::adaptive,
            "Fewer triangles where the shadow map is flat; off: the finest everywhere.");
    d.field("tolerance_m", &LightVolumesSettings::tolerance_m,
            "How far along the light an adaptive mesh may stray from the shadow map.")
        .unit("m")
        .range(0.0, 1000.0);
    d.field("terms", &LightVolumesSettings::terms,
            "Terms of the series for the light along a ray, in steps of 4: more for narrow cones and phase functions.")
        .range(4, 16);
}

/// "render": { "participating_media": { ... } } of a scene. What stands at this level is the ray march's.
struct MediaSettings {
    static constexpr std::string_view kName = "participating_media";
    bool enabled = true;
    Resolution resolution = Resolution::full;
    int32_t steps = 12;
    int32_t light_steps = 8;
    bool jitter = true;
    bool filter = true;
    LightVolumesSettings light_volumes;
};

inline void describe(StructBuilder<MediaSettings>& d) {
    d.doc("Single scattering in media. The march's error falls with the number of steps, its time grows with it.");
    d.field("enabled", &MediaSettings::enabled, "Off: media neither glow nor dim.");
    d.field("resolution", &MediaSettings::resolution, "Half marches a quarter of the pixels and upsamples by depth.",
            {"full", "half"});
    d.field("steps", &MediaSettings::steps,
            "Steps over the part of a ray that lies in a medium and in a light's volume.")
        .range(1, 1024);
    d.field("light_steps", &MediaSettings::light_steps,
            "Samples on the way to a light through noise and grids; other densities need none.")
        .range(1, 256);
    d.field("jitter", &MediaSettings::jitter, "Blue-noise offsets: fine grain instead of bands.");
    d.field("filter", &MediaSettings::filter,
            "Averages 3x3 (at half resolution 5x5) marched pixels of like distance: takes the grain off, softens edges "
            "of shafts.");
    d.field("light_volumes", &MediaSettings::light_volumes, "Of the solver light_volumes.");
}

}  // namespace tyndall::participating_media
