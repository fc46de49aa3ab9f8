// Adds one light that has scattered once inside a solid on its way to the eye.
//
// Along the eye's refracted ray as many places as there are rays are chosen, each standing for the same share of what
// the density lets through; from each a ray goes on to where the light entered (the shadow map). Both parts march the
// density; with OF_VOXELS the second has been, from every voxel (arrive.comp). The sum is the integral of single scattering: exp(-optical depth of both parts) sigma_s p E.
#include "translucency/htsm/object.glsl"
#include "translucency/seen.glsl"
#include "render/shaders/lights.glsl"
#ifdef OF_VOXELS
#include "translucency/htsm/voxels.glsl"
#else
#include "translucency/htsm/entry.glsl"
#endif

uniform int rays;
uniform float keeps;  // 0: the first light takes the place of what the pixel had
layout(location = 0, index = 0) out vec4 gathered;
layout(location = 0, index = 1) out vec4 kept;

void main() {
    Seen seen;
    gathered = vec4(0.0);
    kept = vec4(vec3(keeps), 1.0);
    if (!seen_here(solid.scattering_eta.w, seen)) discard;
    vec3 unit = unit_at(seen.place), direction = unit_direction(seen.inward);
    float length_m = way_out(unit, direction);
    float whole = density_along(unit, direction, length_m, STEPS);
    if (whole <= 0.0) return;
    float guide = max(solid.extinction_guide.w, 1e-3 / whole);
    float share = 1.0 - exp(-guide * whole);
#ifndef OF_VOXELS
    EntryView view = entry_view(seen.place, seen.inward);
#endif
    float step_m = length_m / float(STEPS);
    vec3 advance = direction * step_m, at = unit - 0.5 * advance;
    float before = 0.0, next = 0.0;  // integral of the density up to both ends of the step
    int walked = 0;
    vec3 sum = vec3(0.0), phase;
#if defined(OF_VOXELS) && !defined(BENDS)
    const bool one_phase = light_kind(light_index) == LIGHT_DIRECTIONAL;  // known here, as light_kind is
    phase = phase_at(dot(light_data(light_index).direction_kind.xyz, -seen.inward));
#else
    const bool one_phase = false;
#endif
    for (int i = 0; i < rays; ++i) {
        float wanted = -log(1.0 - share * (float(i) + 0.5) / float(rays)) / guide;
        while (next < wanted && walked < STEPS) {
            before = next;
            at += advance;
            next += density_at(at) * step_m;
            ++walked;
        }
        float within = clamp((wanted - before) / max(next - before, 1e-20), 0.0, 1.0);
        float t = (float(walked - 1) + within) * step_m;
#ifdef OF_VOXELS
        Entry entry = entry_of_voxels(seen.place + t * seen.inward, unit + t * direction);
#else
        Entry entry = entry_toward(view, seen.place, seen.inward, t, STEPS);
#endif
        vec3 weight = exp(guide * wanted - solid.extinction_guide.rgb * (wanted + entry.amount));
        if (!one_phase) phase = phase_at(dot(entry.travel, -seen.inward));
        sum += weight * phase * entry.irradiance;
    }
#ifndef OF_VOXELS
    sum *= left_at_entry(view, seen.place);
#endif
    gathered.rgb = sum * solid.scattering_eta.rgb * (share / (guide * float(rays)) * seen.leaves) * seen.scale;
}
