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
    float spreads[8];
#ifdef DIRECTIONS
    vec3 directions[8];
    vec3 normals[8];
#endif
    for (uint i = 0u; i < count; ++i) {
        ivec2 texel = node_texel(level_begins[0] + n * count + i);
        fluxes[i] = imageLoad(node_fluxes, texel).rgb;
        vec4 place = imageLoad(node_places, texel);
        places[i] = place.xyz;
        spreads[i] = level_begins[0] == 0u ? 0.0 : place.w;
#ifdef DIRECTIONS
        vec4 direction = imageLoad(node_directions, texel);
        directions[i] = direction.xyz;
        normals[i] = unpacked_normal(direction.w);
#endif
    }
    for (uint level = 1u; level <= levels; ++level) {
        count >>= 1u;
        for (uint i = 0u; i < count; ++i) {
            float a = luminance_rec709(fluxes[2u * i]) + kLeast, b = luminance_rec709(fluxes[2u * i + 1u]) + kLeast;
            float share = b / (a + b);
            ivec2 texel = node_texel(level_begins[level] + n * count + i);
            fluxes[i] = fluxes[2u * i] + fluxes[2u * i + 1u];
            vec3 apart = places[2u * i + 1u] - places[2u * i];
            places[i] = places[2u * i] + share * apart;
            spreads[i] = mix(spreads[2u * i], spreads[2u * i + 1u], share) + 0.5 * share * (1.0 - share) * dot(apart, apart);
            imageStore(node_fluxes, texel, vec4(fluxes[i], 0.0));
            imageStore(node_places, texel, vec4(places[i], spreads[i]));
#ifdef DIRECTIONS
            directions[i] = mix(directions[2u * i], directions[2u * i + 1u], share);
            normals[i] = mix(normals[2u * i], normals[2u * i + 1u], share);
            imageStore(node_directions, texel, vec4(directions[i], packed_normal(normals[i])));
#endif
        }
    }
}
