// A solid as HtsmPass keeps it: a grid of density and of what is inside, and the optics that the density multiplies.
#include "physics/constants.glsl"
#include "physics/fresnel.glsl"
#include "physics/intersect.glsl"

layout(std140) uniform Solid {
    mat4 unit_from_world;    // to [0, 1]^3 over the grid
    vec4 scattering_eta;     // rgb 1/m
    vec4 extinction_guide;   // rgb 1/m; w: that of the channels together, by which places are chosen
    vec4 scale_voxel;        // rgb pi over what compose multiplies the base by; w: metres a voxel
    vec4 transport;          // rgb transport colour; w: transport distance, metres
    vec4 view;               // x 1: the object is in the shadow maps
} solid;

uniform sampler3D solid_grid;      // density, share inside
uniform sampler2D phase_table;     // 1/sr over the scattering angle
uniform int steps;

const float kPhaseColumns = 1024.0;
/// A voxel counts whole once so much of it is inside: the borders are told by the mesh and the shadow map, to more than a
/// voxel, and the grid must not thin them.
const float kInsideAll = 0.25;

vec3 phase_at(float u) {
    float column = acos(clamp(u, -1.0, 1.0)) * (kInversePi * (kPhaseColumns - 1.0)) + 0.5;
    return textureLod(phase_table, vec2(column / kPhaseColumns, 0.5), 0.0).rgb;
}

/// Density where the place is inside, in unit coordinates; `inside` is the share there.
float density_at(vec3 unit, out float inside) {
    vec2 grid = textureLod(solid_grid, unit, 0.0).rg;
    inside = grid.y;
    return grid.x * min(grid.y / kInsideAll, 1.0);
}
vec3 unit_at(vec3 p) { return (solid.unit_from_world * vec4(p, 1.0)).xyz; }
vec3 unit_direction(vec3 d) { return mat3(solid.unit_from_world) * d; }

/// Metres along a unit direction until the ray leaves the grid.
float way_out(vec3 unit, vec3 direction) {
    vec3 d = mix(direction, vec3(1e-12), lessThan(abs(direction), vec3(1e-12)));
    vec3 t = max((vec3(0.0) - unit) / d, (vec3(1.0) - unit) / d);
    return max(min(t.x, min(t.y, t.z)), 0.0);
}

/// Integral of the density over `metres`, and how far the last place inside is.
float density_along(vec3 unit, vec3 direction, float metres, out float last_inside) {
    float step_m = metres / float(steps);
    vec3 advance = direction * step_m;
    vec3 at = unit + 0.5 * advance;
    float sum = 0.0, inside;
    last_inside = 0.0;
    for (int i = 0; i < steps; ++i) {
        sum += density_at(at, inside);
        if (inside > 0.5) last_inside = (float(i) + 0.5) * step_m;
        at += advance;
    }
    return sum * step_m;
}

/// Outward normal of the surface near by, from where the inside ends.
vec3 normal_near(vec3 unit, vec3 fallback) {
    vec3 texel = 1.0 / vec3(textureSize(solid_grid, 0));
    vec3 slope;
    for (int k = 0; k < 3; ++k) {
        vec3 offset = vec3(0.0);
        offset[k] = texel[k];
        slope[k] = (textureLod(solid_grid, unit - offset, 0.0).g - textureLod(solid_grid, unit + offset, 0.0).g) / texel[k];
    }
    vec3 world = slope * mat3(solid.unit_from_world);
    float size = length(world);
    return size > 1e-3 / solid.scale_voxel.w ? world / size : fallback;
}
