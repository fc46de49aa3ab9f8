#include "physics/tables.h"

#include "physics/physics.h"

namespace tyndall::physics {
namespace {
constexpr int kSteps = 32;

/// What the lobe's albedo and its grazing part are raised by, so that quadrature and interpolation never leave them
/// below the truth: a surface may lose half a percent of the light, never gain any.
constexpr float kHeadroom = 1.003f;
constexpr float kGrazingHeadroom = 1.006f;

/// The first sample number of the visible normals whose slope is that of the angle s^2 pi/2 when seen from above: steps
/// in s follow both the peak of a smooth lobe and its tail, where the horizon cuts.
float radial_share(float s, float alpha) {
    if (s >= 1.0f) return 1.0f;
    const float slope = square(tan(0.5f * kPi * s * s) / alpha);
    return slope / (1.0f + slope);
}
}  // namespace

vec2 SpecularTable::sample(float nov, float roughness) const {
    const vec2 at = standard_table_coordinate(nov, roughness, float(kSize)) * float(kSize) - 0.5f;
    const ivec2 corner = clamp(ivec2(at), ivec2(0), ivec2(kSize - 2));
    const vec2 f = at - vec2(corner);
    const auto texel = [&](int x, int y) { return texels[size_t(corner.y + y) * kSize + size_t(corner.x + x)]; };
    return mix(mix(texel(0, 0), texel(1, 0), f.x), mix(texel(0, 1), texel(1, 1), f.x), f.y);
}

vec2 ggx_directional_albedo(float nov, float roughness, int steps) {
    const float alpha = ggx_alpha(roughness);
    const float cosine = max(nov, 1e-3f);
    const vec3 v(sqrt(1.0f - cosine * cosine), 0.0f, cosine);
    dvec2 sum(0.0);
    for (int i = 0; i < steps; ++i) {
        const float low = radial_share(float(i) / float(steps), alpha);
        const float high = radial_share(float(i + 1) / float(steps), alpha);
        const float middle = radial_share((float(i) + 0.5f) / float(steps), alpha);
        vec2 ring(0.0f);
        for (int j = 0; j < steps; ++j) {
            // the lobe is symmetric about the plane of v and n: half of the azimuths will do
            const float azimuth = 0.5f * (float(j) + 0.5f) / float(steps) - 0.25f;
            const vec3 h = sample_ggx_visible_normal(vec2(middle, azimuth), v, alpha);
            const float voh = dot(v, h);
            const float weight = ggx_sample_weight(2.0f * voh * h.z - v.z, v.z, alpha);
            const float w = schlick_weight(voh);
            ring += weight * vec2(1.0f - w, w);
        }
        sum += dvec2(ring) * double((high - low) / float(steps));
    }
    return vec2(sum);
}

SpecularTable make_specular_table() {
    SpecularTable table;
    constexpr int kLast = SpecularTable::kSize - 1;
    for (int y = 0; y <= kLast; ++y) {
        for (int x = 0; x <= kLast; ++x) {
            const float nov = square(float(x) / float(kLast));  // the inverse of standard_table_coordinate
            const vec2 albedo = ggx_directional_albedo(nov, float(y) / float(kLast), kSteps);
            const float whole = min((albedo.x + albedo.y) * kHeadroom, 1.0f);
            const float grazing = min(albedo.y * kGrazingHeadroom, whole);
            table.texels[size_t(y) * SpecularTable::kSize + size_t(x)] = vec2(whole - grazing, grazing);
        }
    }
    return table;
}

}  // namespace tyndall::physics
