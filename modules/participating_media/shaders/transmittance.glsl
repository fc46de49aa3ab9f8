// Provider of the light-transmittance seam: media dim the light on its way to p. What has a closed form is exact; uneven media
// are looked up or marched (shadows/media_shadows.h).
#include "participating_media/media.glsl"
#include "participating_media/shadows/read.glsl"
#include "render/shaders/lights.glsl"

vec3 participating_media_transmittance(uint light, vec3 p, vec3 n) {
    vec3 to_light;
    float metres = light_distance(light, p, to_light);
#ifdef EVEN_MEDIA
    return exp(-media_closed_depth(p, to_light, 0.0, metres));
#else
    vec3 depth = vec3(0.0);
#ifdef MEDIA_CLOSED
    depth += media_closed_depth(p, to_light, 0.0, metres);
#endif
    return exp(-depth - light_uneven_depth(light, p, to_light, metres));
#endif
}
