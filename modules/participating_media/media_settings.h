#pragma once
/// What a scene may choose of the rendering of media.

#include "ecs/description.h"

namespace tyndall::participating_media {

enum class Resolution { full, half, quarter };

/// The solver analytic.
struct AnalyticSettings {
    int32_t nodes = 6;
    bool surface_glow = false;
};

inline void describe(StructBuilder<AnalyticSettings>& d) {
    d.doc("Light that meets no shadow, by quadrature of a smooth integrand.");
    d.field("nodes", &AnalyticSettings::nodes,
            "Places on a ray. The error falls exponentially with their number, the time grows with it.")
        .range(2, 64);
    d.field("surface_glow", &AnalyticSettings::surface_glow,
            "Fog around point lights that this solver renders lights surfaces too: light of the second order, which no "
            "other solver has.");
}

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

/// Epipolar sampling.
struct EpipolarSettings {
    int32_t slices = 512;
    int32_t samples = 256;
    int32_t initial_step = 16;
    int32_t shadow_samples = 1024;
    int32_t steps = 32;
    float refinement_threshold = 0.05f;
    bool tree = true;
    bool brute_force = false;
};

inline void describe(StructBuilder<EpipolarSettings>& d) {
    d.doc("Epipolar sampling: rays are marched on few lines through the light's place on the screen.");
    d.field("slices", &EpipolarSettings::slices, "Lines; a quarter of them ends at each side of the picture.")
        .range(16, 4096);
    d.field("samples", &EpipolarSettings::samples, "Samples on a line.").range(16, 4096);
    d.field("initial_step", &EpipolarSettings::initial_step,
            "Every so many samples a ray is marched where the depth has no break; a power of two. At most 4 where "
            "densities vary.")
        .range(1, 64);
    d.field("shadow_samples", &EpipolarSettings::shadow_samples,
            "Samples of the shadow map along a line; a power of two.")
        .range(16, 4096);
    d.field("steps", &EpipolarSettings::steps,
            "Steps in which a ray's light is summed up; shadows within a step are found exactly.")
        .range(1, 256);
    d.field("refinement_threshold", &EpipolarSettings::refinement_threshold,
            "Relative change of the distance between two samples that counts as a break.")
        .range(0.0, 10.0);
    d.field("tree", &EpipolarSettings::tree, "Off: walks along the shadow map texel by texel. Same picture, slower.");
    d.field("brute_force", &EpipolarSettings::brute_force,
            "Marches every pixel instead: the reference of this solver.");
}

/// Screen-space god rays.
struct GodRaysSettings {
    int32_t samples = 32;
    float thickness_m = 1.0f;
    float edge_fade = 0.2f;
};

inline void describe(StructBuilder<GodRaysSettings>& d) {
    d.doc("Screen-space god rays: what stands in the sun's way is looked for in the picture itself.");
    d.field("samples", &GodRaysSettings::samples, "Looks along the way to the sun on the screen.").range(1, 512);
    d.field("thickness_m", &GodRaysSettings::thickness_m,
            "How deep what stands in the light's way is taken to be: the picture shows its front alone.")
        .unit("m")
        .range(0.0, 1e6);
    d.field("edge_fade", &GodRaysSettings::edge_fade,
            "Part of half the picture over which what leaves it fades out of the light's way.")
        .range(1e-3, 1.0);
}

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
    d.field(
        "history", &FroxelSettings::history,
        "Averages over frames, where nothing changed. Off: every frame stands for itself and its pattern is still.");
    d.field("reference", &FroxelSettings::reference,
            "Brute force: a froxel for every 2x2 pixels, four times the depth, 16 samples, no history.");
}

/// How the shadows of uneven media are found.
enum class ShadowMethod { automatic, march, opacity_map, fourier_map, clipmap };

/// "shadows": { ... }: what media take of the light on its way (shadows/media_shadows.h).
struct MediaShadowSettings {
    ShadowMethod method = ShadowMethod::automatic;
    int32_t size = 128;
    int32_t layers = 64;
    int32_t samples = 1;
    int32_t terms = 8;
    int32_t maps = 8;
    int32_t voxels = 64;
    int32_t levels = 2;
    int32_t steps = 32;
    bool operator==(const MediaShadowSettings&) const = default;
};

inline void describe(StructBuilder<MediaShadowSettings>& d) {
    d.doc(
        "Shadows of noise, grids and gradients; those of even media, blobs and height fog are exact and cost nothing "
        "here.");
    d.field("method", &MediaShadowSettings::method,
            "march: light_steps samples toward the light for each lookup. opacity_map: a map of optical depths seen "
            "from each light. fourier_map: its Fourier series, less memory. clipmap: voxels of extinction around the "
            "camera, one for all lights. auto: opacity_map for the first lights, clipmap for those beyond.",
            {"auto", "march", "opacity_map", "fourier_map", "clipmap"});
    d.field("size", &MediaShadowSettings::size, "Texels along a side of a light's map.").range(8, 2048);
    d.field("layers", &MediaShadowSettings::layers,
            "Depths between the media's nearest and farthest place at which a map is gathered.")
        .range(2, 1024);
    d.field("samples", &MediaShadowSettings::samples,
            "Samples of the density from a depth to the next, and along each side of a voxel of the clipmap.")
        .range(1, 16);
    d.field("terms", &MediaShadowSettings::terms, "Cosines of a Fourier map.").range(1, 32);
    d.field("maps", &MediaShadowSettings::maps, "So many lights have a map; those beyond share the clipmap.")
        .range(0, 64);
    d.field("voxels", &MediaShadowSettings::voxels, "Along a side of each level of the clipmap.").range(8, 256);
    d.field("levels", &MediaShadowSettings::levels,
            "Of the clipmap: the last holds all uneven media, each before it half of the one after, at the camera.")
        .range(1, 6);
    d.field("steps", &MediaShadowSettings::steps, "Of a lookup through the clipmap.").range(1, 256);
}

/// "render": { "participating_media": { ... } } of a scene. What stands at this level is the ray march's.
struct MediaSettings {
    static constexpr std::string_view kName = "participating_media";
    bool enabled = true;
    int32_t auto_marches = 4;
    Resolution resolution = Resolution::full;
    int32_t steps = 12;
    int32_t light_steps = 8;
    int32_t eye_steps = 24;
    bool jitter = true;
    bool filter = true;
    bool temporal = false;
    bool shadow_mips = false;
    float least_transmittance = 0.0001f;
    AnalyticSettings analytic;
    LightVolumesSettings light_volumes;
    EpipolarSettings epipolar;
    GodRaysSettings god_rays;
    FroxelSettings froxels;
    MediaShadowSettings shadows;
};

inline void describe(StructBuilder<MediaSettings>& d) {
    d.doc("Single scattering in media. The march's error falls with the number of steps, its time grows with it.");
    d.field("enabled", &MediaSettings::enabled, "Off: media neither glow nor dim.");
    d.field("auto_marches", &MediaSettings::auto_marches,
            "The solver auto marches as long as there are no more pairs of a light and a medium to march than this; "
            "beyond, the froxels are cheaper.")
        .range(0, 1 << 20);
    d.field(
        "resolution", &MediaSettings::resolution,
        "Half marches a quarter of the pixels, quarter a sixteenth, and upsamples by depth; silhouettes are marched "
        "in full.",
        {"full", "half", "quarter"});
    d.field("steps", &MediaSettings::steps,
            "Steps over the part of a ray that lies in a medium and in a light's volume.")
        .range(1, 1024);
    d.field("light_steps", &MediaSettings::light_steps,
            "Samples through noise and grids on the way to the eye, and to lights whose shadows are marched; other "
            "densities "
            "need none.")
        .range(1, 256);
    d.field("eye_steps", &MediaSettings::eye_steps,
            "Samples on the way to the eye of what is seen through noise and grids: too few are grain; other densities "
            "need none.")
        .range(1, 256);
    d.field("jitter", &MediaSettings::jitter, "Blue-noise offsets: fine grain instead of bands.");
    d.field("filter", &MediaSettings::filter,
            "Averages 3x3 marched pixels of like distance: takes the grain off, softens edges of shafts.");
    d.field("temporal", &MediaSettings::temporal,
            "Averages the march over frames in which no light, caster or medium changes. Off: every frame stands for "
            "itself and its pattern is still.");
    d.field(
        "shadow_mips", &MediaSettings::shadow_mips,
        "Leaves out the ends of rays that are in shadow, by least depths over parts of the shadow map, so that steps "
        "fall where light is. For spots and suns whose shadow is one map.");
    d.field("least_transmittance", &MediaSettings::least_transmittance,
            "Rays end where less than this share of the light gets to the eye; so much of it, at most, is lost.")
        .range(0.0, 0.5);
    d.field("analytic", &MediaSettings::analytic, "The solver analytic.");
    d.field("light_volumes", &MediaSettings::light_volumes, "Of the solver light_volumes.");
    d.field("epipolar", &MediaSettings::epipolar, "Of the solver epipolar.");
    d.field("god_rays", &MediaSettings::god_rays, "Of the solver god_rays.");
    d.field("froxels", &MediaSettings::froxels, "Of the solver froxels.");
    d.field("shadows", &MediaSettings::shadows, "What uneven media take of the light on its way.");
}

}  // namespace tyndall::participating_media
