// What each group of points receives of light that leaves others (emit.comp) and meets the body again, once more in every
// round, and how much of what is around it sees.
#include "translucency/points/groups.glsl"

uniform sampler2D sights;  // groups' numbers

void main() {
    uint group = gl_GlobalInvocationID.x;
    if (group >= point_count / kSightGroup) return;
    vec4 begins = texelFetch(groups, node_texel(group), 0);
    uint i = uint(begins.x), last = uint(begins.y);
    vec3 sum = vec3(0.0);
    if (i < last) {
        do {
            uint other = uint(texelFetch(sights, ivec2(i % 1024u, i / 1024u), 0).r);
            sum += imageLoad(group_light, node_texel(2u * other)).rgb;
        } while (++i < last);
    }
    imageStore(group_light, node_texel(2u * group + 1u), vec4(sum, kSightRays - (begins.y - begins.x)) / kSightRays);
}
