// Adds one light that has entered a solid and leaves it toward the eye.
//
// Once scattered (FORM_KI, FORM_HERY): places along the eye's refracted ray, each as far from where light entered as the
// map says: sigma_s p(u) E exp(-sigma_t (s_o + s_i)) (Ki 2009; Hery 2003). More often scattered: what leaves where it
// entered, of which blur.frag has most with FORM_KI; with FORM_GREEN the map's light faded by the thickness (Green 2004).
#include "render/shaders/lights.glsl"
#include "seams/light_transmittance.glsl"
#include "translucency/phase_table.glsl"
#include "translucency/scatter_maps/solid.glsl"
#include "translucency/scatter_maps/map.glsl"
#include "translucency/seen.glsl"

uniform uint light_index;
layout(location = 0) out vec4 gathered;

/// Where light grazes the solid, a texel of the map is deep; within so many its depth is not to be relied on.
const float kUnsure = 4.0;

/// Metres from a place `depth` metres below the surface back to where light has entered that has come `mapped` metres by
/// the map: as far as in a ball of the body's size, where that is as good as the map.
float metres_inside(float mapped, float depth, float cosine, float unsure) {
    float radius = solid.body.w, below = max(radius - depth, 0.0) * cosine;
    float ball = sqrt(below * below + depth * max(2.0 * radius - depth, 0.0)) - below;
    return mix(ball, mapped, smoothstep(0.5 * unsure, unsure, abs(mapped - ball)));
}

vec3 scattered_once(Seen seen, vec3 start) {
    vec3 along = light_direction(seen.inward), to_light, sum = vec3(0.0);
    light_distance(light_index, seen.place, to_light);
    float cosine = dot(seen.normal, to_light), steep = -dot(seen.inward, seen.normal);
    float texel = kUnsure * exp2(view.perspective_texel.y);
    float unsure = min(texel / max(abs(cosine), 0.01), sqrt(2.0 * solid.body.w * texel));  // a ball's sagitta at most
    for (int i = 0; i < STEPS; ++i) {
        vec2 step = solid.steps[i].xy;
        vec3 at = start + step.x * along;
        vec2 uv = map_uv(at);
        float lod = round(1.0 + map_lod(log2(step.y) - 2.0));  // whole mips: half the reads
        vec4 light = textureLod(entry_light, uv, lod), way = textureLod(entry_way, uv, lod);
        float covered = 1.0 / max(light.a, 1e-3), shorter = length(way.xyz) * covered;
        float z = at.z - view.window.w;
        float entered = z - way.w * covered;
        // the part of its stretch that lies behind where the eye's ray comes out again: toward the light or away from it
        float left = along.z < 0.0 ? entered : last_exit(uv) - z;
        float inside = clamp(left / (step.y * max(abs(along.z), 0.2)) + 0.5, 0.0, 1.0);
        float metres = metres_inside(max(entered, 0.0) * slant(at), step.x * steep, cosine, unsure) * shorter;
        inside *= clamp(4.0 * light.a, 0.0, 1.0);
        vec3 phase = phase_at(-dot(way.xyz, seen.inward) * covered / max(shorter, 1e-6));
        sum += solid.step_weights[i].rgb * exp(-solid.extinction.rgb * metres) * phase * light.rgb * (covered * shorter * inside);
    }
    return sum;
}

/// Light that leaves the surface: rgb exitance, that part of it that comes from near by and from deep inside.
struct Leaving {
    vec3 near, deep;
};

/// What has entered here: as much as leaves of it scattered more than once.
vec3 entered_here(Seen seen, out float cosine) {
    vec3 to_light;
    vec3 irradiance = light_irradiance(light_index, seen.place, to_light);
    cosine = clamp(dot(seen.normal, to_light), 0.0, 1.0);
    return irradiance * light_transmittance(light_index, seen.place, seen.normal) * entering(cosine) * multiple_share(cosine) *
           enters_to_wander(seen.place);
}

Leaving local(Seen seen, vec3 start) {
    float cosine;
    vec3 here = entered_here(seen, cosine);
#ifdef FORM_KI
    return Leaving(here * own_share(cosine) / max(solid.body.rgb, vec3(1e-6)), vec3(0.0));
#endif
#ifdef FORM_HERY
    return Leaving(here, vec3(0.0));
#endif
#ifdef FORM_GREEN
    vec2 uv = map_uv(start);
    vec4 flux = textureLod(entry_flux, uv, 2.0);
    float z = flux.a / max(luminance_rec709(flux.rgb), 1e-20) + view.window.w;
    vec3 depth = solid.green.rgb * (max(start.z - z, 0.0) * slant(start));
#ifdef RAMP
    vec3 left = max(vec3(1.0) - 0.5 * depth, vec3(0.0));
#else
    vec3 left = exp(-depth);
#endif
    flux.rgb /= max(textureLod(entry_light, uv, 2.0).a, 0.05);
    return Leaving(here * (1.0 - solid.green.w), flux.rgb * left * solid.body.rgb * solid.green_amount.rgb);
#endif
}

void main() {
    Seen seen;
    gathered = vec4(0.0);
    if (seen_here(solid.extinction.w, seen)) {
        vec3 start = light_place(seen.place);
#ifndef FORM_GREEN
        gathered.rgb += scattered_once(seen, start) * seen.leaves * seen.scale / paint_ends_at(seen.place).rgb;  // which mix.comp takes all light times
#endif
#ifndef ONCE
        float cosine = standard_nov(seen.normal, -eye_ray(gl_FragCoord.xy / frame.size_time.xy));
        Leaving leaving = local(seen, start);
        gathered.rgb += (near_leaves(cosine) * leaving.near + deep_leaves(cosine) * leaving.deep) /
                        (max(interior.base_entering.rgb, vec3(1e-4)) * mean_entering());
#endif
    }
}
