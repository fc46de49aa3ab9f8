// What programs and the providers of seams hand to one another (render/seams.h). World space, metres; radiance in the
// scene-linear working space.
#include "physics/standard_surface.glsl"

/// A point to be lit. `view` and `normal` are unit vectors; `view` points to the eye.
struct ShadingPoint {
    vec3 position;
    vec3 normal;
    vec3 view;
    float roughness;  ///< perceptual
    uint model;       ///< number of the shading model
    vec2 uv;          ///< of the screen, 0..1: where a model finds its own targets
};

/// Where the shadows of a light are looked up for a point, and along which normal.
struct LightReceiver {
    vec3 position;
    vec3 normal;
};

/// One light at that point.
struct LightSample {
    vec3 direction_to_light;  ///< unit
    vec3 irradiance;     ///< lux per channel on a plane that faces the light, shadowed
    vec3 transmittance;  ///< the shadows in it: share of the light that gets there
    vec3 unshadowed;     ///< what would arrive with nothing on the way, lux per channel
    uint light;          ///< its number, for light_transmittance
};

/// Light from everywhere but the lights.
struct IndirectLight {
    vec3 irradiance;  ///< lux per channel on the surface, cosine-weighted
    vec3 specular;    ///< radiance from the mirror direction, prefiltered for the roughness
};

/// What lies between the eye and a point.
struct MediaSegment {
    vec3 in_scatter;     ///< radiance added towards the eye
    vec3 transmittance;  ///< share of the radiance behind that arrives
};
