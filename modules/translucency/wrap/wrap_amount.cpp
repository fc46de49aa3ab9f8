#include "wrap/wrap_amount.h"

#include <algorithm>
#include <cmath>

namespace tyndall::translucency {
namespace {

/// The first moment at a = 1.
constexpr float kWidest = 0.75f;

}  // namespace

WrapAmount wrap_amount(const Optics& optics, Model model, float body_radius) {
    if (!(body_radius > 0.0f)) return {};
    constexpr int kSteps = 256;
    const RadialKernel kernel(optics, model, Scaling::published, body_radius);
    glm::vec3 sum(0.0f), before(0.0f);
    for (int i = 1; i <= kSteps; ++i) {  // chords: most of them short
        const float x = float(i) / kSteps, middle = (float(i) - 0.5f) / kSteps;
        const float chord = 2.0f * middle * middle;  // over the radius
        const glm::vec3 within = kernel.share_within(2.0f * x * x * body_radius);
        sum += (within - before) * (0.5f * chord * chord);
        before = within;
    }
    glm::vec3 moment;
    for (int c = 0; c < 3; ++c) moment[c] = std::clamp(1.0f - sum[c] / std::max(before[c], 1e-6f), 0.0f, 1.0f);
    // half of what the channel wraps that spreads least: of the shares tried the nearest to traced spheres
    const float most = 0.5f + 0.5f * std::max({moment.x, moment.y, moment.z, kWidest});
    WrapAmount amount;
    amount.a = 3.0f / most - 3.0f;
    for (int c = 0; c < 3; ++c) {
        amount.wide[c] = std::min((most - moment[c]) / (most - kWidest), 1.0f);
        amount.even[c] = std::max(1.0f - moment[c] / kWidest, 0.0f);
        amount.wide[c] -= amount.even[c];
    }
    return amount;
}

float wrapped(float cosine, float a) {
    const float above = std::max(cosine + a, 0.0f) / (1.0f + a);
    return std::pow(above, 1.0f + a) * (2.0f + a) / (2.0f * (1.0f + a));
}

}  // namespace tyndall::translucency
