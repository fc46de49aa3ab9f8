// A cluster of points a work group, which looks at one list of nodes.
#include "translucency/points/cloud.glsl"
#include "translucency/kernel.glsl"

layout(std430) readonly buffer Lists { uint lists[]; };
layout(std430) readonly buffer ListBegins { uint list_begins[]; };

/// Exitance at `place` by the light that has entered everywhere but at `point` itself, lm/m2, not scaled there. a: luminance of what
/// comes from deep inside.
vec4 gathered(uint cluster, uint point, vec3 place) {
    uint last = list_begins[cluster + 1u];
    vec4 sum = vec4(0.0);
    for (uint i = list_begins[cluster]; i < last; ++i) {
        uint node = lists[i];
        vec3 flux = node_fluxes[node].rgb;
        if (flux == vec3(0.0)) continue;
        vec3 d = node_places[node].xyz - place;
        flux = node == point ? vec3(0.0) : flux;
        sum += vec4(flux, luminance(flux)) * kernel_at(dot(d, d));
    }
    return sum;
}
