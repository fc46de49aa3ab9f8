// Three levels of the tree: light of eight nodes, of their halves and quarters, and where its middle is.
#include "translucency/points/cloud.glsl"

uniform uint level_begins[4];  // of the nodes that are there, and the next levels
uniform uint eighths;          // nodes of the last of them
uniform uint levels;           // of the three that there are

const float kLeast = 1e-30;

void main() {
    uint n = gl_GlobalInvocationID.x;
    if (n >= eighths) return;
    uint count = 1u << levels;
    vec3 fluxes[8];
    vec3 places[8];
    for (uint i = 0u; i < count; ++i) {
        fluxes[i] = imageLoad(node_fluxes, node_texel(level_begins[0] + n * count + i)).rgb;
        places[i] = imageLoad(node_places, node_texel(level_begins[0] + n * count + i)).xyz;
    }
    for (uint level = 1u; level <= levels; ++level) {
        count >>= 1u;
        for (uint i = 0u; i < count; ++i) {
            float a = luminance(fluxes[2u * i]) + kLeast, b = luminance(fluxes[2u * i + 1u]) + kLeast;
            fluxes[i] = fluxes[2u * i] + fluxes[2u * i + 1u];
            places[i] = mix(places[2u * i], places[2u * i + 1u], b / (a + b));
            imageStore(node_fluxes, node_texel(level_begins[level] + n * count + i), vec4(fluxes[i], 0.0));
            imageStore(node_places, node_texel(level_begins[level] + n * count + i), vec4(places[i], 0.0));
        }
    }
}
