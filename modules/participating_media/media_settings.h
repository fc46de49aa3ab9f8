#pragma once
/// What a scene may choose of the rendering of media.

#include "ecs/description.h"

namespace tyndall::participating_media {

enum class Resolution { full, half };

/// The solver analytic.
struct AnalyticSettings {
    int32_t nodes = 6;
};

inline void describe(StructBuilder<AnalyticSettings>& d) {
    d.doc("Light that meets no shadow, by quadrature of a smooth integrand.");
    d.field("nodes", &AnalyticSettings::nodes,
            "Places on a ray. The error falls exponentially with their number, the time grows with it.")
        .range(2, 64);
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
    AnalyticSettings analytic;
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
    d.field("analytic", &MediaSettings::analytic, "The solver analytic.");
}

}  // namespace tyndall::participating_media
