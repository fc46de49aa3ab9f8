// Takes the irradiance of a solid's pixels away and begins with light from all around: what passes straight, and what
// scatters once. Of the latter a thick solid in even light returns 2/3 (1 - ln 2) of the albedo, and a thin one as much
// as it scatters.
#include "translucency/htsm/object.glsl"
#include "translucency/seen.glsl"
#include "seams/indirect_light.glsl"
#include "translucency/paint.glsl"

layout(location = 0, index = 0) out vec4 gathered;
layout(location = 0, index = 1) out vec4 kept;

const float kThick = 0.2045685;

/// Radiance inside over that outside, behind a boundary that is met about as steeply as in front.
float scale_inside() {
#ifdef BENDS
    return solid.scattering_eta.w * solid.scattering_eta.w;
#else
    return 1.0;
#endif
}

void main() {
    Seen seen;
    if (!seen_here(solid.scattering_eta.w, seen)) discard;
    vec3 unit = unit_at(seen.place), direction = unit_direction(seen.inward);
    float whole = density_along(unit, direction, way_out(unit, direction), STEPS);
    vec3 irradiance = indirect_light(seen.place, seen.normal, seen.normal, 1.0).irradiance;
    vec3 albedo = solid.scattering_eta.rgb / max(solid.extinction_guide.rgb, vec3(1e-6));
    vec3 scattered = albedo * kThick * (vec3(1.0) - exp(-solid.extinction_guide.rgb * (whole / kThick)));
    vec3 passes = exp(-solid.extinction_guide.rgb * whole) * seen.leaves * scale_inside();
    vec3 behind = indirect_light(seen.place, seen.inward, seen.inward, 0.0).specular;  // mirrored: straight on
    gathered = vec4((irradiance * kInversePi * scattered + behind * passes) * seen.scale * enters_past_paint(seen.place), 0.0);
    kept = vec4(0.0, 0.0, 0.0, 1.0);
}
