// Light of the sun scattered in an even medium, shaded by what the picture shows (Mitchell 2007; Livermore 2012, 4.2).
//
// The light's way to each point of the eye ray runs on the screen from the pixel toward the sun. A surface seen there
// shades those points of the ray whose light passes behind it. The mean over the way of what is left of the unshadowed
// integral is the result; the sky leaves all. The part of the way that is off the screen counts as free: as the sun leaves
// the picture and goes beside the camera that part grows to all, and the shafts fade without a step.
#include "participating_media/god_rays/even_sun.glsl"

uniform sampler2D scene_depth;
uniform float farthest;     // metres; rays that hit nothing end here
uniform vec3 sun_clip;      // x, y, w of the direction to the sun in clip space
uniform int samples;        // along the way on the screen

in vec2 uv;
out vec4 in_scatter;  // rgb radiance, a unused

// How much of the unshadowed integral lies before t: exact at both ends, an exponential between.
float share_before(float t, float t0, float t1, float fall) {
    return (1.0 - exp(-fall * clamp((t - t0) / (t1 - t0), 0.0, 1.0))) / (1.0 - exp(-fall));
}

// Mean share of the integral that is lit, 0..1. Along the way u grows from 0; the sun is at u = 1 / sun_clip.z.
float lit_share(Ray ray, float t0, float t1, float fall) {
    vec2 from = uv * 2.0 - 1.0;
    vec2 way = sun_clip.xy - from * sun_clip.z;
    vec2 to_edge = (sign(way) - from) / mix(way, vec2(1e-9), lessThan(abs(way), vec2(1e-9)));
    float edge = max(min(to_edge.x, to_edge.y), 0.0);
    float known = clamp(edge * sun_clip.z, 0.0, 1.0);  // the part of the way that is on the screen
    float last = known / max(sun_clip.z, 1e-9);
    float axis_per_metre = dot(ray.direction, -transpose(mat3(frame.view))[2]);
    float jitter = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));  // Jimenez 2014
    ivec2 size = textureSize(scene_depth, 0);
    float sum = 0.0;
    for (int i = 0; i < (known > 0.0 ? samples : 0); ++i) {
        float u = (float(i) + jitter) / float(samples) * last;
        ivec2 texel = clamp(ivec2((from + u * way + 1.0) * 0.5 * vec2(size)), ivec2(0), size - 1);
        float depth = texelFetch(scene_depth, texel, 0).r;
        float passes = view_depth(max(depth, 1e-12)) * (1.0 - u * sun_clip.z) / axis_per_metre;
        sum += share_before(depth > 0.0 ? passes : t1, t0, t1, fall);
    }
    return 1.0 - known + known * sum / float(samples);
}

void main() {
    float depth = texelFetch(scene_depth, ivec2(gl_FragCoord.xy), 0).r;
    Ray ray = Ray(frame.eye_near.xyz, eye_ray(uv));
    float t0 = 0.0, t1 = depth > 0.0 ? eye_distance(uv, depth) : farthest;
    in_scatter = vec4(0.0);
    if (!clip_to_medium(medium, ray.origin, ray.direction, t0, t1)) return;
    vec3 to_light;
    vec3 irradiance = light_irradiance(light_index, ray.origin, to_light);
    WayIn way = way_in(ray, to_light);
    float sigma_t = dot(media[medium].sigma_t.rgb, vec3(1.0 / 3.0));
    float fall = clamp(sigma_t * (t1 - t0 + metres_in(way, t1) - metres_in(way, t0)), -30.0, 30.0);
    fall = abs(fall) < 0.01 ? 0.01 : fall;
    in_scatter.rgb = media[medium].sigma_s_phase.rgb * irradiance * phase(dot(-to_light, -ray.direction)) *
                     unshadowed_integral(way, t0, t1) * lit_share(ray, t0, t1, fall);
}
