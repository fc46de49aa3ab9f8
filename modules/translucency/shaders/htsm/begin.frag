// Takes the irradiance of a solid's pixels away and begins with light from all around, scattered once. In a thick solid
// that lights evenly from all around that is 2/3 (1 - ln 2) of the albedo; in a thin one it is as much as is scattered.
#include "translucency/htsm/seen.glsl"
#include "seams/indirect_light.glsl"

layout(location = 0, index = 0) out vec4 gathered;
layout(location = 0, index = 1) out vec4 kept;

const float kThick = 0.2045685;

void main() {
    Seen seen;
    if (!seen_here(seen)) discard;
    vec3 unit = unit_at(seen.place), direction = unit_direction(seen.inward);
    float whole = density_along(unit, direction, way_out(unit, direction), STEPS);
    vec3 irradiance = indirect_light(seen.place, seen.normal, seen.normal, 1.0).irradiance;
    vec3 albedo = solid.scattering_eta.rgb / max(solid.extinction_guide.rgb, vec3(1e-6));
    vec3 scattered = albedo * kThick * (vec3(1.0) - exp(-solid.extinction_guide.rgb * (whole / kThick)));
    gathered = vec4(irradiance * kInversePi * scattered * seen.scale, 0.0);
    kept = vec4(0.0, 0.0, 0.0, 1.0);
}
