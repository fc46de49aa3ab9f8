// Takes the irradiance of a solid's pixels away and begins with light from all around, of which as much leaves as has
// entered near by.
#include "translucency/seen.glsl"
#include "translucency/scatter_maps/solid.glsl"
#include "seams/indirect_light.glsl"

uniform float ambient;  // 0: no light from all around
layout(location = 0, index = 0) out vec4 gathered;
layout(location = 0, index = 1) out vec4 kept;

void main() {
    Seen seen;
    if (!seen_here(solid.extinction.w, seen)) discard;
    float cosine = standard_nov(seen.normal, -eye_ray(gl_FragCoord.xy / frame.size_time.xy));
    vec3 irradiance = indirect_light(seen.place, seen.normal, seen.normal, 1.0).irradiance;
    vec3 leaves = irradiance * mean_leaving() * near_leaves(cosine) / max(interior.base_entering.rgb, vec3(1e-4));
    gathered = vec4(ambient * leaves * leaves_where_it_enters(seen.place), 0.0);
    kept = vec4(0.0, 0.0, 0.0, 1.0);
}
