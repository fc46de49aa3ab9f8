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

Entry entry_of_voxels(vec3 unit, vec3 travel) {
    vec4 light = textureLod(arriving, unit, 0.0);
#ifdef BENDS
    travel = normalize(textureLod(travels, unit, 0.0).xyz + 1e-6 * travel);
#endif
    return Entry(travel, light.rgb, max(light.a, 0.0));
}
