#include "oily_layer.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "physics/physics.h"
#include "physics/tables.h"
#include "skin_component.h"

namespace tyndall::skin {
namespace {

using physics::SpecularTable;

/// Directional albedo of Kelemen's lobe with Schlick's Fresnel, by quadrature about the mirror direction's half vector.
float kelemen_albedo(float cosine, float roughness, float f0) {
    constexpr int kSteps = 48;
    const glm::vec3 view(std::sqrt(1.0f - cosine * cosine), 0.0f, cosine);
    float sum = 0.0f;
    for (int i = 0; i < kSteps; ++i)
        for (int j = 0; j < kSteps; ++j) {
            // half vectors, closer together near the normal
            const float t = (float(i) + 0.5f) / kSteps, theta = 0.5f * physics::kPi * t * t;
            const float phi = physics::kPi * (float(j) + 0.5f) / kSteps;
            const glm::vec3 h(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
            const float voh = glm::dot(view, h);
            const float nol = 2.0f * voh * h.z - view.z;
            if (voh <= 0.0f || nol <= 0.0f) continue;
            const float fresnel = f0 + (1.0f - f0) * physics::schlick_weight(voh);
            // d omega_l = 4 (v.h) d omega_h, and |l + v| = 2 (v.h)
            const float area = std::sin(theta) * physics::kPi * t / kSteps * 2.0f * physics::kPi / kSteps;
            sum += physics::kelemen_brdf(h.z, 4.0f * voh * voh, roughness) * fresnel * nol * 4.0f * voh * area;
        }
    return sum;
}

}  // namespace

OilyLayer oily_layer(const glm::vec4& parameters) {
    static_assert(OilyLayer::kSize == SpecularTable::kSize);
    constexpr int kLast = OilyLayer::kSize - 1;
    const SpecularTable table = physics::make_specular_table();
    const float f0 = physics::f0_from_eta(kSkinIor);
    const auto ggx = [&](float cosine, float roughness) {
        const glm::vec2 pair = table.sample(cosine, std::min(roughness, 1.0f));
        return f0 * pair.x + pair.y;
    };
    OilyLayer layer;
    for (int y = 0; y <= kLast; ++y) {
        const float roughness = float(y) / float(kLast);
        const auto mirrored = [&](float cosine) {
            if (parameters.w > 0.5f) return kelemen_albedo(cosine, roughness, f0);
            return std::lerp(ggx(cosine, roughness * parameters.x), ggx(cosine, roughness * parameters.y),
                             parameters.z);
        };
        constexpr int kSteps = 32;
        float mean = 0.0f;
        for (int i = 0; i < kSteps; ++i) {
            const float cosine = (float(i) + 0.5f) / kSteps;
            mean += 2.0f * cosine * (1.0f - std::min(mirrored(cosine), 1.0f)) / kSteps;
        }
        for (int x = 0; x <= kLast; ++x) {
            const float cosine = std::max(physics::square(float(x) / float(kLast)), 1e-3f);
            const float taken = std::min(mirrored(cosine), 1.0f);
            layer.texels[size_t(y * OilyLayer::kSize + x)] = {
                (1.0f - taken) / mean, std::min(ggx(cosine, roughness) / std::max(taken, 1e-6f), 1.0f)};
        }
    }
    return layer;
}

}  // namespace tyndall::skin
