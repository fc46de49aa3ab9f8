#include "physics/diffusion_profile.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

namespace tyndall::physics {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

template <class Lobe>
glm::vec3 sum(const DiffusionProfile& profile, const Lobe& lobe_at) {
    glm::vec3 total(0.0f);
    for (const DiffusionLobe& lobe : profile.lobes) total += lobe.weight * lobe_at(lobe.variance_m2);
    return total;
}

}  // namespace

glm::vec3 DiffusionProfile::at(float r) const {
    return sum(*this, [r](float v) { return std::exp(-r * r / (2.0f * v)) / (2.0f * kPi * v); });
}

glm::vec3 DiffusionProfile::line(float x) const {
    return sum(*this, [x](float v) { return std::exp(-x * x / (2.0f * v)) / std::sqrt(2.0f * kPi * v); });
}

glm::vec3 DiffusionProfile::edge(float x) const {
    return sum(*this, [x](float v) { return 0.5f * std::erfc(-x / std::sqrt(2.0f * v)); });
}

glm::vec3 DiffusionProfile::within(float r) const {
    return sum(*this, [r](float v) { return -std::expm1(-r * r / (2.0f * v)); });
}

glm::vec3 DiffusionProfile::through(float s) const {
    return sum(*this, [s](float v) { return std::exp(-s * s / v); });
}

glm::vec3 DiffusionProfile::mean_square() const {
    return sum(*this, [](float v) { return 2.0f * v; });
}

DiffusionProfile DiffusionProfile::scaled(float factor) const {
    DiffusionProfile result = *this;
    for (DiffusionLobe& lobe : result.lobes) lobe.variance_m2 *= factor * factor;
    return result;
}

void DiffusionProfile::normalise() {
    std::ranges::sort(lobes, {}, &DiffusionLobe::variance_m2);
    std::vector<DiffusionLobe> merged;
    glm::vec3 total(0.0f);
    for (const DiffusionLobe& lobe : lobes) {
        if (merged.empty() || merged.back().variance_m2 != lobe.variance_m2)
            merged.push_back(lobe);
        else
            merged.back().weight += lobe.weight;
        total += lobe.weight;
    }
    for (DiffusionLobe& lobe : merged) lobe.weight /= glm::max(total, glm::vec3(1e-20f));
    lobes = std::move(merged);
}

DiffusionProfile six_gaussian_skin() {
    constexpr float kMm2 = 1e-6f;
    DiffusionProfile profile{{{0.0064f * kMm2, {0.233f, 0.455f, 0.649f}},
                              {0.0484f * kMm2, {0.100f, 0.336f, 0.344f}},
                              {0.187f * kMm2, {0.118f, 0.198f, 0.0f}},
                              {0.567f * kMm2, {0.113f, 0.007f, 0.007f}},
                              {1.99f * kMm2, {0.358f, 0.004f, 0.0f}},
                              {7.41f * kMm2, {0.078f, 0.0f, 0.0f}}}};
    profile.normalise();
    return profile;
}

}  // namespace tyndall::physics
