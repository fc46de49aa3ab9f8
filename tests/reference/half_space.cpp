#include "half_space.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tyndall::reference {

Measured half_space_reflectance(const glm::vec3& albedo, float eta, float angle_deg, int pixels, int64_t samples) {
    constexpr float kSize = 4000.0f;
    const float angle = glm::radians(angle_deg);
    RenderScene scene =
        uniform_field(camera_at(10.0f * glm::vec3(std::sin(angle), std::cos(angle), 0.0f), glm::vec3(0.0f), 1e-3f));
    Surface box =
        shape(Primitive::box, between({-0.5f * kSize, -kSize, -0.5f * kSize}, {0.5f * kSize, 0.0f, 0.5f * kSize}));
    ScatteringInterior interior;
    interior.sigma_s_per_m = albedo;
    interior.sigma_a_per_m = 1.0f - albedo;
    interior.eta = eta;
    box.interior = interior;
    scene.surfaces.push_back(std::move(box));
    TraceSettings settings = square_picture(pixels, samples);
    settings.min_order = 1;
    return measure(scene, settings, samples);
}

double chandrasekhar_reflectance(double albedo, double cosine) {
    constexpr int kPoints = 400;  // midpoints of x, mu = x^2: H is steep near 0
    std::vector<double> mu(kPoints), weight(kPoints), h(kPoints, 1.0);
    for (size_t i = 0; i < kPoints; ++i) {
        const double x = (static_cast<double>(i) + 0.5) / kPoints;
        mu[i] = x * x, weight[i] = 2.0 * x / kPoints;
    }
    const double root = std::sqrt(1.0 - albedo);
    const auto next = [&](double at) {
        double sum = 0.0;
        for (size_t j = 0; j < kPoints; ++j) sum += weight[j] * mu[j] * h[j] / (at + mu[j]);
        return 1.0 / (root + 0.5 * albedo * sum);
    };
    for (double change = 1.0; change > 1e-9;) {
        change = 0.0;
        for (size_t i = 0; i < kPoints; ++i) {
            const double value = next(mu[i]);
            change = std::max(change, std::abs(value - h[i]));
            h[i] = value;
        }
    }
    return 1.0 - next(cosine) * root;
}

}  // namespace tyndall::reference
