// The part of each eye ray that one light's volume and one medium share, as span.glsl wants it.
#include "participating_media/light_source.glsl"
#include "participating_media/span.glsl"

uniform sampler2D scene_depth;
uniform float farthest;  // metres; rays that hit nothing end here

in vec2 uv;
out vec4 span;

// Optical depth on the way from the light to the ray's point t.
vec3 from_light(Ray ray, float t) {
    vec3 p = ray.origin + t * ray.direction;
    vec3 to_light;
    float metres = light_distance(light_index, p, to_light);
    return media_optical_depth(p, to_light, 0.0, metres, 1);
}

void main() {
    float depth = texelFetch(scene_depth, ivec2(gl_FragCoord.xy), 0).r;
    Ray ray = Ray(frame.eye_near.xyz, eye_ray(uv));
    float t0 = 0.0, t1 = depth > 0.0 ? eye_distance(uv, depth) : farthest;
    span = vec4(0.0);
    if (!clip_to_medium(medium, ray.origin, ray.direction, t0, t1)) return;
    if (!light_segment(light_index, ray.origin, ray.direction, t0, t1)) return;
    vec3 fall = from_light(ray, t1) - from_light(ray, t0) + media_optical_depth(ray.origin, ray.direction, t0, t1, 1);
    Passing passing = passing_of(light_position(light_index) - ray.origin, ray.direction);
    Span made = make_span(passing, t0, t1, dot(fall, vec3(1.0 / 3.0)));
    span = vec4(made.low, made.high, made.decay, made.scale);
}
