#pragma once
/// What a scene may choose of the rendering of media.

#include "ecs/description.h"

namespace tyndall::participating_media {

enum class Resolution { full, half };

/// "froxels": { ... }: the view-aligned grid (froxels/froxel_pass.h).
struct FroxelSettings {
    int32_t width = 160;
    int32_t height = 90;
    int32_t depth = 64;
    float range_m = 128.0f;
    float even_m = 8.0f;
    int32_t samples = 1;
    int32_t samples_alone = 8;
    bool history = true;
    bool reference = false;
};

inline void describe(StructBuilder<FroxelSettings>& d) {
    d.doc("The froxels: a grid of places in front of the camera, in which light is gathered.");
    d.field("width", &FroxelSettings::width, "Froxels across the picture.").range(1, 1024);
    d.field("height", &FroxelSettings::height, "Froxels up the picture.").range(1, 1024);
    d.field("depth", &FroxelSettings::depth, "Froxels along the view, between the media's nearest and farthest place.")
        .range(1, 512);
    d.field("range_m", &FroxelSettings::range_m,
            "The grid ends here at the latest; what lies beyond is integrated in closed form, a few pieces a pixel.")
        .unit("m")
        .range(0.1, 1e5);
    d.field("even_m", &FroxelSettings::even_m,
            "Up to about here froxels are of like depth; beyond, their depth grows with distance.")
        .unit("m")
        .range(0.01, 1e5);
    d.field("samples", &FroxelSettings::samples, "Places looked at in a froxel, a frame.").range(1, 64);
    d.field("samples_alone", &FroxelSettings::samples_alone, "The same in a froxel that has no history.").range(1, 64);
    d.field("history", &FroxelSettings::history,
            "Averages over frames, where nothing changed. Off: every frame stands for itself and its pattern is still.");
    d.field("reference", &FroxelSettings::reference,
            "Brute force: a froxel for every 2x2 pixels, four times the depth, 16 samples, no history.");
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
    FroxelSettings froxels;
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
    d.field("froxels", &MediaSettings::froxels, "Of the solver froxels.");
}

}  // namespace tyndall::participating_media
