// Emission and light from all around behind the froxels' grid.
#include "participating_media/environment.glsl"
#include "participating_media/froxels/beyond.glsl"

uniform uint glowing_media;  // a bit each
uniform uint lit_media;

in vec2 uv;
out vec4 in_scatter;  // rgb radiance, a unused

void main() {
    in_scatter = vec4(0.0);
    Beyond ray = beyond_ray(uv);
    if (ray.t0 >= ray.t1) return;
    ray.t0 = max(ray.t0, 1e-3);
    vec3 before = media_transmittance(ray.origin, ray.direction, 0.0, ray.t0);
    float t = ray.t0;
    for (int k = 0; k < kPieces; ++k) {
        float next = ray.t0 * pow(ray.t1 / ray.t0, float(k + 1) / float(kPieces));
        vec3 p = ray.origin + sqrt(t * next) * ray.direction;
        vec3 around = environment_share(p) * environment_transmittance(p);
        vec3 sum = vec3(0.0);
        for (int i = 0; i < media_count; ++i) {
            vec3 light = (lit_media >> uint(i) & 1u) != 0u ? media[i].sigma_s_phase.rgb * environment_scattered(i, p, ray.direction) * around : vec3(0.0);
            light += (glowing_media >> uint(i) & 1u) != 0u ? medium_emission(i, p) : vec3(0.0);
            sum += light * beyond_column(i, ray, t, next);
        }
        vec3 tau = media_optical_depth(ray.origin, ray.direction, t, next, 1);
        in_scatter.rgb += before * sum * mean_transmittance(tau);
        before *= exp(-tau);
        t = next;
    }
}
