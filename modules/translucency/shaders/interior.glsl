// What is inside a translucent solid: InteriorBlock of interior_block.h.
#include "physics/constants.glsl"
#include "physics/fresnel.glsl"
#include "physics/units.glsl"
#include "translucency/paint.glsl"

const int kLeavingCosines = 16, kKernelGaussians = 16, kRoughCosines = 32;
layout(std140) uniform Interior {
    vec4 leaving[kLeavingCosines];
    vec4 deep[kLeavingCosines];
    vec4 kernel[kKernelGaussians];
    vec4 mean_leaving;
    vec4 base_entering;
    vec4 boundary;
    vec4 kernel_rate;
    vec4 sigma_s_reduced;
    vec4 sigma_a;
    vec4 published;
    vec4 slanted[kLeavingCosines];
    vec4 plane_wide, plane_narrow;
    vec4 rough[kRoughCosines];
} interior;

float interior_eta() { return interior.boundary.x; }
/// Of diffuse light: the share that enters, and that leaves of what entered.
float mean_entering() { return interior.base_entering.w; }
vec3 mean_leaving() { return interior.boundary.z > 0.0 ? interior.mean_leaving.rgb : vec3(1.0); }

/// Share of the light that arrives at a cosine 0..1 to the normal that enters.
float entering_share(float cosine) {
    float x = sqrt(cosine) * float(kRoughCosines - 1);
    int i = min(int(x), kRoughCosines - 2);
    float rough = mix(interior.rough[i].x, interior.rough[i + 1].x, x - float(i));
    return 1.0 - fresnel_dielectric(cosine, interior_eta()) * rough;
}
/// Share of irradiance (on a plane that faces the light) that enters a unit of area.
float entering(float cosine) { return cosine * entering_share(cosine); }

/// Of diffuse light that has entered, what leaves a half-space of the same inside, whatever the kernel says.
vec3 half_space_returns() { return interior.boundary.z > 0.0 ? interior.mean_leaving.rgb : interior.base_entering.rgb; }

float cosine_inside(float cosine) {
    return sqrt(max(1.0 - (1.0 - cosine * cosine) / (interior_eta() * interior_eta()), 0.0));
}
vec3 leaving_at(float cosine) {
    float x = cosine_inside(cosine) * float(kLeavingCosines - 1);
    int i = min(int(x), kLeavingCosines - 2);
    return mix(interior.leaving[i].rgb, interior.leaving[i + 1].rgb, x - float(i));
}
/// Share of what entered at this cosine that leaves somewhere; 1 where the kernel says itself how much that is.
vec3 leaving_share(float cosine) { return interior.boundary.z > 0.0 ? leaving_at(cosine) : vec3(1.0); }
/// Light inside, just below the boundary, toward a cosine outside, over its mean: of light that entered near by. By
/// reciprocity it leaves as what enters from there would.
vec3 near_pattern(float cosine) {
    if (interior.boundary.z == 0.0) return vec3(1.0);
    return leaving_at(cosine) / max(interior.mean_leaving.rgb, vec3(1e-6));
}
/// The same of light that has come from far through the inside: the limb is darker.
vec3 deep_pattern(float cosine) {
    if (interior.boundary.z == 0.0) return vec3(1.0);
    float x = cosine_inside(cosine) * float(kLeavingCosines - 1);
    int i = min(int(x), kLeavingCosines - 2);
    return mix(interior.deep[i].rgb, interior.deep[i + 1].rgb, x - float(i));
}
/// The directional dipole's kernel is normalised for light along the normal and returns less of what enters slantwise.
vec3 slanted_scale(float cosine) {
    float x = cosine_inside(cosine) * float(kLeavingCosines - 1);
    int i = min(int(x), kLeavingCosines - 2);
    return mix(interior.slanted[i].rgb, interior.slanted[i + 1].rgb, x - float(i));
}
/// Metres along the surface that refracted light goes before it first collides, over the sine outside.
float first_path() { return interior.boundary.y; }

/// Of the kernel's integral over a plane the share that lies farther away than `r` metres.
vec3 kernel_share_beyond(float r) {
    float g = exp2(-1.44269504 * interior.kernel_rate.x * r * r), area = 1.0;  // over the widest Gaussian's
    vec3 sum = vec3(0.0), all = vec3(0.0);
    for (int k = kKernelGaussians - 1; k >= 0; --k) {
        vec3 whole = area * interior.kernel[k].rgb;
        all += whole;
        sum += g * whole;
        g *= g;
        area *= 0.5;
    }
    return sum / max(all, vec3(1e-30));
}

/// Exitance per flux, 1/m2, at a squared distance (radial_kernel.h).
vec3 kernel_at(float r2) {
    float g = exp2(-1.44269504 * interior.kernel_rate.x * r2);
    vec3 sum = vec3(0.0);
    for (int k = kKernelGaussians - 1; k >= 0; --k) {
        sum += g * interior.kernel[k].rgb;
        g *= g;
    }
    return sum;
}

