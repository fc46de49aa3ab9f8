// Adds one light as Shopf (2006, table 4.1) has it: straight rays from where it entered near by, in a pattern that
// widens, to the pixel: T_c / n sum max(0, (2 T_d - (D_i + alpha_i)) / T_d) f(theta_i) E_i, with the E_i of his text.
//
// He does not say on what scale f and E are. Here E is what enters and is not returned by the surface, and f is at most
// 1 / 4 pi: then no more leaves a ball than has entered it, however clear it is.
#include "translucency/htsm/object.glsl"
#include "translucency/seen.glsl"
#include "translucency/htsm/entry.glsl"

uniform int rays;
uniform float ring_m;  // radius of the pattern's first ring
layout(location = 0, index = 0) out vec4 gathered;
layout(location = 0, index = 1) out vec4 kept;

/// In rings of four, each twice as wide as the one before and turned by half a step.
vec2 pattern(int i) {
    if (i == 0) return vec2(0.0);
    int ring = (i - 1) / 4;
    float angle = (float(i - 1) + 0.5 * float(ring & 1)) * (0.5 * kPi);
    return exp2(float(ring)) * vec2(cos(angle), sin(angle));
}

void main() {
    Seen seen;
    gathered = vec4(0.0);
    kept = vec4(1.0);  // his formula adds to what the surface itself returns
    if (!seen_here(solid.scattering_eta.w, seen)) discard;
    vec3 right = light_data(light_index).right_cos_outer.xyz, up = light_data(light_index).up_cos_inner.xyz;
    float voxel = solid.voxel_cast.x, farthest = solid.transport.w;
    vec3 start = unit_at(seen.place);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < rays; ++i) {
        vec2 offset = pattern(i) * ring_m;
        vec3 beside = seen.place + offset.x * right + offset.y * up, to_light;
        float distance_m = light_distance(light_index, beside, to_light);
        bool found;
        vec3 entered = beside + to_light * metres_to_first(entry_view(beside, right), 0.0, distance_m, found);
        vec3 unit = unit_at(entered);
        float own = inside_at(unit - unit_direction(to_light) * (0.5 * voxel));
        if (!found || clamp(unit, vec3(0.0), vec3(1.0)) != unit) own = 0.0;
        vec3 ray = entered - seen.place;
        float way = length(ray);
        ray = way > 1e-9 ? ray / way : -seen.normal;
        float cosine = clamp(dot(normal_near(unit, to_light), to_light), 0.0, 1.0);
        vec3 irradiance = light_irradiance(light_index, entered, to_light);
        irradiance *= enters_past_paint(entered) * cosine * (1.0 - fresnel_dielectric(cosine, solid.scattering_eta.w));
        irradiance *= light_transmittance(light_index, entered + to_light * (2.0 * voxel), vec3(0.0));
        float amount = density_along(start, unit_direction(ray), way, STEPS);
        float left = max(0.0, (2.0 * farthest - (way + amount)) / farthest);
        sum += min(own / kInsideAll, 1.0) * left * phase_at(dot(ray, -seen.normal)) * irradiance;
    }
    vec3 passes = (vec3(1.0) - boundary_base.rgb) / max(4.0 * kPi * solid.most_phase.rgb, vec3(1.0));
    gathered.rgb = passes * solid.transport.rgb * sum / float(rays) * seen.scale;
}
