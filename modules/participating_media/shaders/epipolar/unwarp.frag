// From the epipolar lines back to pixels: the two samples nearest on each of the two slices nearest, by how well their
// distances fit. Pixels that none fits are marched, as are all when `brute_force` asks for it.
#include "participating_media/epipolar/lines.glsl"
#include "participating_media/light_source.glsl"

uniform sampler2D scene_depth;
uniform sampler2D lines;       // column = slice
uniform sampler2D slice_ends;  // pixels from, to
uniform vec2 epipole;
uniform float farthest;   // metres; rays that hit nothing end here
uniform float threshold;  // relative difference of distances beyond which a sample does not fit
uniform int steps;        // of marched pixels
uniform int brute_force;

in vec2 uv;
out vec4 in_scatter;  // rgb radiance, a unused

vec3 march(Ray ray, float end) {
    float t0 = 0.0, t1 = end;
    if (!clip_to_medium(medium, ray.origin, ray.direction, t0, t1)) return vec3(0.0);
    if (!light_segment(light_index, ray.origin, ray.direction, t0, t1)) return vec3(0.0);
    vec3 to_light = light_position(light_index) - ray.origin;
    float closest = dot(to_light, ray.direction);
    float passing = max(length(to_light - closest * ray.direction), 1e-3);
    float low = LIGHT_KIND == 2 ? t0 : atan((t0 - closest) / passing);
    float high = LIGHT_KIND == 2 ? t1 : atan((t1 - closest) / passing);
    float width = (high - low) / float(steps);
    float jitter = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));  // Jimenez 2014
    vec3 before = media_transmittance(ray.origin, ray.direction, 0.0, t0), sum = vec3(0.0);
    float reached = t0;
    int i = 0;
    do {
        float v = low + (float(i) + jitter) * width;
        float t = LIGHT_KIND == 2 ? v : clamp(closest + passing * tan(v), t0, t1);
        float offset = t - closest;
        float metres = LIGHT_KIND == 2 ? width : (passing + offset * offset / passing) * width;
        before *= exp(-media_optical_depth(ray.origin, ray.direction, reached, t, 1));
        reached = t;
        sum += source(ray, t) * before * metres;
    } while (++i < steps);
    return media[medium].sigma_s_phase.rgb * sum;
}

void main() {
    float depth = texelFetch(scene_depth, ivec2(gl_FragCoord.xy), 0).r;
    float metres = depth > 0.0 ? eye_distance(uv, depth) : farthest;
    ivec2 count = textureSize(lines, 0);
    vec2 size = frame.size_time.xy;
    vec2 out_of_picture = inside_picture(epipole, gl_FragCoord.xy, size);
    float slice = border_parameter(epipole + out_of_picture.y * (gl_FragCoord.xy - epipole), size) * 0.25 * float(count.x);
    vec3 sum = vec3(0.0);
    float total = 0.0, best = 1e9;
    for (int k = 0; k < 2; ++k) {
        int column = (int(slice) + k) % count.x;
        float across = k == 0 ? 1.0 - fract(slice) : fract(slice);
        vec4 ends = texelFetch(slice_ends, ivec2(column, 0), 0);
        vec2 along = ends.zw - ends.xy;
        float at = clamp(dot(gl_FragCoord.xy - ends.xy, along) / max(dot(along, along), 1e-6), 0.0, 1.0) * float(count.y - 1);
        for (int i = 0; i < 2; ++i) {
            vec4 texel = texelFetch(lines, ivec2(column, min(int(at) + i, count.y - 1)), 0);
            float misfit = texel.a < 0.0 ? 1e9 : abs(texel.a - metres) / max(metres, 1e-3);
            float weight = (across * (i == 0 ? 1.0 - fract(at) : fract(at)) + 1e-4) / (5e-3 + misfit);
            sum += texel.a < 0.0 ? vec3(0.0) : texel.rgb * weight;
            total += weight;
            best = min(best, misfit);
        }
    }
    vec3 result = sum / total;
    if (best > threshold || brute_force != 0) result = march(Ray(frame.eye_near.xyz, eye_ray(uv)), metres);
    in_scatter = vec4(result, 0.0);
}
