// Provider of the light-transmittance seam: media dim the light on its way to p.
#include "participating_media/media.glsl"
#include "render/shaders/lights.glsl"

vec3 participating_media_transmittance(uint light, vec3 p, vec3 n) {
    vec3 to_light;
    float metres = light_distance(light, p, to_light);
    return media_transmittance(p, to_light, 0.0, metres);
}
