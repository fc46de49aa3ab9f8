// Single scattering of one light whose shadows are not looked for in one medium, along the eye ray, without a march:
// Gauss-Legendre quadrature in the variable in which what reaches the eye is nearly even (span.glsl).
// It converges exponentially, since nothing on the way jumps; no noise, no bands.
#include "participating_media/light_source.glsl"
#include "participating_media/span.glsl"

uniform sampler2D scene_depth;
uniform float farthest;     // metres; rays that hit nothing end here
uniform vec2 nodes[64];  // x in -1..1 and weight
uniform int node_count;  // not a constant: compilers would unroll all media into each node

in vec2 uv;
out vec4 in_scatter;  // rgb radiance, a unused

// Behind so many e-foldings nothing is looked for.
const float kDeepest = 16.0;

vec3 optical_depth_to_eye(Ray ray, float t) { return media_optical_depth(ray.origin, ray.direction, 0.0, t, 1); }

// Of the way from the light to the ray's point t and on to the eye, mean of the channels.
float optical_depth_of_way(Ray ray, float t) {
    vec3 p = ray.origin + t * ray.direction;
    vec3 to_light;
    float metres = light_distance(light_index, p, to_light);
    return dot(optical_depth_to_eye(ray, t) + media_optical_depth(p, to_light, 0.0, metres, 1), vec3(1.0 / 3.0));
}

void main() {
    float depth = texelFetch(scene_depth, ivec2(gl_FragCoord.xy), 0).r;
    Ray ray = Ray(frame.eye_near.xyz, eye_ray(uv));
    float t0 = 0.0, t1 = depth > 0.0 ? eye_distance(uv, depth) : farthest;
    in_scatter = vec4(0.0);
    if (!clip_to_medium(medium, ray.origin, ray.direction, t0, t1)) return;
    if (!light_segment(light_index, ray.origin, ray.direction, t0, t1)) return;
    // from the clearest channel's mean extinction, so that thick fog has its nodes where it is seen
    vec3 through = (optical_depth_to_eye(ray, t1) - optical_depth_to_eye(ray, t0)) / kDeepest;
    t1 = t0 + (t1 - t0) / max(1.0, min(through.x, min(through.y, through.z)));
    Passing passing = passing_of(light_position(light_index) - ray.origin, ray.direction);
    Span span = make_span(passing, t0, t1, optical_depth_of_way(ray, t1) - optical_depth_of_way(ray, t0));
    vec3 sum = vec3(0.0);
    for (int i = 0; i < node_count; ++i) {
        float metres;
        float t = from_parameter(span, passing, nodes[i].x, metres);
        sum += source(ray, t) * exp(-optical_depth_to_eye(ray, t)) * (nodes[i].y * metres);
    }
    in_scatter.rgb = media[medium].sigma_s_phase.rgb * sum;
}
