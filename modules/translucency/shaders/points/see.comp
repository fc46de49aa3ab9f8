// What each point receives of all that is no light: what is around, where the body does not hide it, and light that leaves
// other points (emit.comp) and meets the body again, once more in every round.
#include "translucency/points/cloud.glsl"

uniform sampler2D open_light;
uniform sampler2D emitted;  // the same as point_light
layout(rgba32f) writeonly uniform image2D point_light;  // of two texels a point the second: irradiance, lux

void main() {
    uint point = gl_GlobalInvocationID.x;
    if (point >= point_count) return;
    uint first = sights_begin(point), last = sights_begin(point + 1u), i = first;
    vec3 sum = vec3(0.0);
    if (i < last) {
        do {
            uint other = uint(texelFetch(sights, ivec2(i % 1024u, i / 1024u), 0).r);
            sum += texelFetch(emitted, node_texel(2u * other), 0).rgb;
        } while (++i < last);
    }
    float open = 1.0 - float(last - first) / float(kSightRays);
    vec3 irradiance = open * texelFetch(open_light, node_texel(point), 0).rgb + sum / float(kSightRays);
    imageStore(point_light, node_texel(2u * point + 1u), vec4(irradiance, 0.0));
}
