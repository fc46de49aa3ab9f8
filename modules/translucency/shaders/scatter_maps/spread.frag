// Adds the blurred light of all lights: from the four places around the pixel, those that lie in the surface's plane.
#include "translucency/scatter_maps/places.glsl"
#include "translucency/scatter_maps/solid.glsl"
#include "translucency/seen.glsl"

uniform sampler2D blurred_near;
uniform sampler2D blurred_deep;
layout(location = 0) out vec4 gathered;

vec3 spread(Seen seen) {
    vec2 at = 0.5 * (gl_FragCoord.xy - 0.5);  // most have the lowest of their four
    ivec2 first = ivec2(floor(at)), last = textureSize(blur_places, 0) - 1;
    vec2 part = at - vec2(first);
    vec3 near = vec3(0.0), deep = vec3(0.0);
    float sum = 0.0, per_metre = 0.5 / pixel_footprint(seen.place);
    for (int i = 0; i < 4; ++i) {
        ivec2 offset = ivec2(i & 1, i >> 1), texel = clamp(first + offset, ivec2(0), last);
        vec2 found = texelFetch(blur_places, texel, 0).xy;
        vec2 weights = mix(1.0 - part, part, vec2(offset));
        float off = dot(place_of(texel, max(found, vec2(1e-6, 0.0))) - seen.place, seen.normal) * per_metre;
        float weight = found.x > 0.0 ? (weights.x * weights.y + 1e-3) / (1.0 + off * off) : 0.0;
        near += weight * texelFetch(blurred_near, texel, 0).rgb;
        deep += weight * texelFetch(blurred_deep, texel, 0).rgb;
        sum += weight;
    }
    float cosine = standard_nov(seen.normal, -eye_ray(gl_FragCoord.xy / frame.size_time.xy));
    vec3 leaves = (near_leaves(cosine) * near + deep_leaves(cosine) * deep) / max(sum, 1e-12);
    return leaves / (max(interior.base_entering.rgb, vec3(1e-4)) * mean_entering());
}

void main() {
    Seen seen;
    gathered = vec4(0.0);
    if (seen_here(solid.extinction.w, seen)) gathered.rgb = spread(seen);
}
