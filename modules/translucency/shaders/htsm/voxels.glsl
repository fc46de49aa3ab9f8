// What arrive.comp has found out for every voxel.
#include "translucency/htsm/object.glsl"
#include "render/shaders/lights.glsl"

uniform sampler3D arriving;  // irradiance, integral of the density on the way
#ifdef BENDS
uniform sampler3D travels;  // direction of travel inside
#endif
uniform uint light_index;

/// Light that has come straight to a place inside, through the boundary.
struct Entry {
    vec3 travel;      // unit direction of travel inside
    vec3 irradiance;  // on a plane across that direction
    float amount;     // integral of the density along the way inside
};

/// To a place, which is `unit` in the grid.
Entry entry_of_voxels(vec3 place, vec3 unit) {
    vec4 light = textureLod(arriving, unit, 0.0);
    vec3 to_light;
    light_distance(light_index, place, to_light);
    vec3 travel = -to_light;
#ifdef BENDS
    travel = normalize(textureLod(travels, unit, 0.0).xyz + 1e-6 * travel);
#endif
    return Entry(travel, light.rgb, max(light.a, 0.0));
}
