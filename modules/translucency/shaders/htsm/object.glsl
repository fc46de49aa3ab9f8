// A solid as HtsmPass keeps it: grids of its density and of what is inside, and the optics that the density multiplies.
//
// BENDS is defined where the boundary refracts, STEPS is how often a march looks at the density: a CPU that renders pays
// for both sides of branches and for loops that it does not know the length of.
#include "physics/constants.glsl"
#include "physics/fresnel.glsl"
#include "translucency/phase_table.glsl"

layout(std140) uniform Solid {
    mat4 unit_from_world;   // to [0, 1]^3 over the grid
    mat4 world_from_unit;
    vec4 scattering_eta;    // rgb 1/m, index of refraction
    vec4 extinction_guide;  // rgb 1/m; w: their mean, by which places are chosen
    vec4 voxel_cast;        // x metres a voxel; y 1: the solid is in the shadow maps
    vec4 transport;         // rgb transport colour; w: transport distance, metres
    vec4 most_phase;        // rgb the phase function's largest value, 1/sr
} solid;

uniform sampler3D solid_density;  // 0 outside
uniform sampler3D solid_inside;   // share of a voxel

/// Where so much of a voxel is inside, the light of a map's border is the solid's own (kInsideAll of object_grid.h).
const float kInsideAll = 0.5;

vec3 unit_at(vec3 p) { return (solid.unit_from_world * vec4(p, 1.0)).xyz; }
vec3 unit_direction(vec3 d) { return mat3(solid.unit_from_world) * d; }
float density_at(vec3 unit) { return textureLod(solid_density, unit, 0.0).r; }
float inside_at(vec3 unit) { return textureLod(solid_inside, unit, 0.0).r; }

/// Metres along a unit direction until the ray leaves the grid.
float way_out(vec3 unit, vec3 direction) {
    vec3 d = mix(direction, vec3(1e-12), lessThan(abs(direction), vec3(1e-12)));
    vec3 t = max(-unit / d, (vec3(1.0) - unit) / d);
    return max(min(t.x, min(t.y, t.z)), 0.0);
}

/// Integral of the density over `metres`, in `count` steps.
float density_along(vec3 unit, vec3 direction, float metres, int count) {
    float step_m = metres / float(max(count, 1));
    vec3 advance = direction * step_m;
    vec3 at = unit + 0.5 * advance;
    float sum = 0.0;
    for (int i = 0; i < count; ++i) {
        sum += density_at(at);
        at += advance;
    }
    return sum * step_m;
}

/// Outward normal of the surface near by, from where the inside ends.
vec3 normal_near(vec3 unit, vec3 fallback) {
    vec3 texel = 1.0 / vec3(textureSize(solid_inside, 0));
    vec3 x = vec3(texel.x, 0.0, 0.0), y = vec3(0.0, texel.y, 0.0), z = vec3(0.0, 0.0, texel.z);
    vec3 slope = vec3(inside_at(unit - x) - inside_at(unit + x), inside_at(unit - y) - inside_at(unit + y),
                      inside_at(unit - z) - inside_at(unit + z)) / texel;
    vec3 world = slope * mat3(solid.unit_from_world);
    float size = length(world);
    return size > 1e-3 / solid.voxel_cast.x ? world / size : fallback;
}
