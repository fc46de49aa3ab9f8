#include "texture_space/lobe_plan.h"

#include <algorithm>
#include <cmath>

namespace tyndall::skin {
namespace {

/// Of a bilinear lookup between texels, in texels: the variance of a hat, the mean over where it falls.
constexpr float kLookup = 1.0f / 6.0f;
/// Of the mean of four texels, in the smaller texels.
constexpr float kMeanOfFour = 0.25f;

float texels2_of_level(int level) {
    return std::ldexp(1.0f, 2 * level);
}

/// What lookups on the way from a level to the picture spread, in texels of level 0.
float spread_up(int level) {
    float spread = 0.0f;
    for (int i = 0; i <= level; ++i) spread += kLookup * texels2_of_level(i);
    return spread;
}

float spread_down(int from, int to) {
    float spread = 0.0f;
    for (int i = from; i < to; ++i) spread += kMeanOfFour * texels2_of_level(i);
    return spread;
}

/// Of weights q^(i^2), i from -radius to radius; texels squared.
float variance_of(float q, int radius) {
    double sum = 1.0, second = 0.0;
    for (int i = 1; i <= radius; ++i) {
        const double weight = 2.0 * std::pow(double(q), i * i);
        sum += weight;
        second += weight * i * i;
    }
    return float(second / sum);
}

}  // namespace

LobePlan plan_lobes(const physics::DiffusionProfile& profile, const LobeMap& map) {
    // below this a lobe narrows by its samples
    constexpr float kLeastTexels2 = 1.0f, kDeviations = 2.8f;
    LobePlan plan;
    const float per_m2 = 1.0f / (map.texel_m * map.texel_m);
    float variance = 0.0f, spared = 0.0f;  // spread so far: variance - spared, the latter in texels of level 0
    int level = 0;
    for (const physics::DiffusionLobe& lobe : profile.lobes) {
        const auto left = [&](int to) {
            return per_m2 * (lobe.variance_m2 - variance) + spared - spread_up(to) - spread_down(level, to);
        };
        if (plan.blurs.empty() && left(0) < 0.02f) {
            plan.sharp += lobe.weight;
            continue;
        }
        int to = level;
        while (to + 1 < map.levels && left(to + 1) >= kLeastTexels2 * texels2_of_level(to + 1)) ++to;
        LobeBlur blur;
        blur.level = to;
        blur.variance_m2 = lobe.variance_m2 - variance;
        blur.less_texels2 = (spread_up(to) + spread_down(level, to) - spared) / texels2_of_level(to);
        blur.weight = lobe.weight;
        const float widest = per_m2 * map.densest * map.densest * blur.variance_m2 / texels2_of_level(to);
        blur.radius = std::clamp(int(std::ceil(kDeviations * std::sqrt(widest))), 1, kMaxRadius);
        plan.blurs.push_back(blur);
        variance = lobe.variance_m2;
        spared = spread_up(to);
        level = to;
    }
    return plan;
}

std::vector<float> kernel_bases(int radius) {
    std::vector<float> bases;
    const float deviation = float(radius) / kCutOff;
    const float most = std::exp(-0.5f / (deviation * deviation));
    for (int column = 0; column < kKernelColumns; ++column) {
        const float wanted = deviation * deviation * float(column) / float(kKernelColumns - 1);
        float low = 0.0f, high = most;
        for (int i = 0; i < 30; ++i) {
            const float middle = 0.5f * (low + high);
            (variance_of(middle, radius) < wanted ? low : high) = middle;
        }
        bases.push_back(0.5f * (low + high));
    }
    return bases;
}

}  // namespace tyndall::skin
