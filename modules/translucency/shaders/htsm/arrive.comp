// Marches from every voxel of a solid to where the light that shines at it has entered.
#include "translucency/htsm/entry.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f) uniform image3D arriving;
#ifdef BENDS
layout(rgba32f) uniform image3D travels;
#endif

void main() {
    ivec3 voxel = ivec3(gl_GlobalInvocationID), size = imageSize(arriving);
    if (any(greaterThanEqual(voxel, size))) return;
    vec3 unit = (vec3(voxel) + 0.5) / vec3(size);
    // those that no place inside is blended from need no light
    float most = 0.0;
    for (int i = 0; i < 8; ++i)
        most = max(most, inside_at(unit + (vec3(i & 1, (i >> 1) & 1, i >> 2) - 0.5) * 1.2 / vec3(size)));
    vec3 p = (solid.world_from_unit * vec4(unit, 1.0)).xyz, to_light;
    light_distance(light_index, p, to_light);
    EntryView view = entry_view(p, to_light);
    Entry entry = entry_toward(view, p, to_light, 0.0, most > 0.0 ? STEPS : 0);
    entry.irradiance *= left_at_entry(view, p);
    imageStore(arriving, voxel, vec4(entry.irradiance, entry.amount));
#ifdef BENDS
    imageStore(travels, voxel, vec4(entry.travel, 0.0));
#endif
}
