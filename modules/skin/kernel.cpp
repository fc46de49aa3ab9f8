#include "kernel.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

namespace tyndall::skin {
namespace {

constexpr int kSteps = 2048;
/// Light beyond the kernel's end, of the channel that spreads most.
constexpr float kLeftOut = 0.002f;

float mean(const glm::vec3& v) {
    return (v.x + v.y + v.z) / 3.0f;
}

/// Ends of `cells` cells from `middle` to `far`, a share of `importance` each, none narrower than `least` but where all
/// must be. The first is `middle`.
template <class Importance>
std::vector<float> cell_ends(int cells, float middle, float far, float least, const Importance& importance) {
    const float width = (far - middle) / kSteps;
    std::vector<float> density(kSteps);
    for (int i = 0; i < kSteps; ++i) density[size_t(i)] = importance(middle + (float(i) + 0.5f) * width);
    // the factor at which the density, nowhere above one cell in `least`, makes `cells`
    const float most = 1.0f / std::max(least, 1e-9f);
    const auto cells_at = [&](float factor) {
        double sum = 0.0;
        for (const float d : density) sum += double(std::min(d * factor, most) * width);
        return float(sum);
    };
    float low = 0.0f, high = 1.0f;
    while (cells_at(high) < float(cells) && high < 1e30f) high *= 4.0f;
    for (int i = 0; i < 60; ++i) (cells_at(0.5f * (low + high)) < float(cells) ? low : high) = 0.5f * (low + high);
    std::vector<float> ends{middle};
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        sum += double(std::min(density[size_t(i)] * high, most) * width);
        if (sum >= double(ends.size()) && int(ends.size()) < cells) ends.push_back(middle + float(i + 1) * width);
    }
    while (int(ends.size()) <= cells) ends.push_back(ends.size() == size_t(cells) ? far : ends.back() + least);
    return ends;
}

}  // namespace

float reach(const physics::DiffusionProfile& profile) {
    float low = 0.0f, high = 8.0f * std::sqrt(profile.lobes.back().variance_m2);
    const auto left = [&](float x) {
        const glm::vec3 beyond = 2.0f * profile.edge(-x);
        return std::max({beyond.x, beyond.y, beyond.z});
    };
    for (int i = 0; i < 40; ++i) (left(0.5f * (low + high)) > kLeftOut ? low : high) = 0.5f * (low + high);
    return high;
}

LineKernel line_kernel(const physics::DiffusionProfile& profile, int taps_a_side, float least_m) {
    const float far = std::max(reach(profile), 1e-6f);
    // the middle cell is a pixel wide, or as wide as all would be
    const float middle = 0.5f * std::max(least_m, far / (4.0f * float(taps_a_side) + 1.0f));
    const std::vector<float> ends = cell_ends(taps_a_side, middle, std::max(far, middle * 2.0f), least_m,
                                              [&](float x) { return std::sqrt(mean(profile.line(x))); });
    LineKernel kernel;
    glm::vec3 total = 2.0f * profile.edge(middle) - 1.0f;
    kernel.taps.emplace_back(total, 0.0f);
    for (int i = 0; i < taps_a_side; ++i) {
        const float low = ends[size_t(i)], high = ends[size_t(i) + 1];
        const glm::vec3 weight = profile.edge(high) - profile.edge(low);
        constexpr int kParts = 32;
        float moment = 0.0f, sum = 0.0f;
        for (int j = 0; j < kParts; ++j) {
            const float x = low + (high - low) * (float(j) + 0.5f) / kParts;
            const float light = mean(profile.line(x));
            moment += light * x;
            sum += light;
        }
        kernel.taps.emplace_back(weight, sum > 0.0f ? moment / sum : 0.5f * (low + high));
        total += 2.0f * weight;
    }
    for (glm::vec4& tap : kernel.taps) tap /= glm::vec4(total, 1.0f);
    return kernel;
}

namespace {

/// What averaging over nine pixels adds to the variance along each axis, pixels squared.
constexpr float kAveraged = 2.0f / 3.0f;

/// What becomes the profile when nine pixels are averaged.
physics::DiffusionProfile before_average(physics::DiffusionProfile profile, float pixel_m) {
    constexpr float kLeast_m2 = 1e-12f;
    for (physics::DiffusionLobe& lobe : profile.lobes)
        lobe.variance_m2 = std::max(lobe.variance_m2 - kAveraged * pixel_m * pixel_m, kLeast_m2);
    return profile;
}

/// Shares that stay in the middle, for the profile `wanted`: as the narrowed profile has them, and a seventh of what
/// more would make the variance the profile's, which lobes narrower than what averaging adds have made too large. With
/// all of it edges would be too wide, with none too narrow: from 10 to 90 % the taps' own are 0.94 to 1.06 of the
/// profile's, the mean 1.00, for pixels of 0.2 to 0.8 mm and all places among the nine.
glm::vec3 middle_share(const physics::DiffusionProfile& wanted, const std::vector<DiscTap>& rings,
                       const glm::vec3& within, float pixel_m) {
    constexpr float kSeventh = 1.0f / 7.0f;
    glm::vec3 variance(0.0f), sum(1e-12f);
    for (const DiscTap& ring : rings) {
        variance += ring.weight * 0.5f * glm::dot(ring.place, ring.place);
        sum += ring.weight;
    }
    const glm::vec3 averaged = variance / sum + kAveraged * pixel_m * pixel_m;
    const glm::vec3 all = 1.0f - 0.5f * wanted.mean_square() / glm::max(averaged, glm::vec3(1e-12f));
    return glm::mix(within, glm::clamp(all, 0.0f, 1.0f), kSeventh);
}

}  // namespace

std::vector<DiscTap> disc_kernel(const physics::DiffusionProfile& profile, int count, float pixel_m) {
    constexpr float kGoldenAngle = 2.39996323f;
    const physics::DiffusionProfile narrowed = before_average(profile, pixel_m);
    const float far = std::max(reach(profile), 1e-6f);
    const float middle = 0.5f * pixel_m;
    // rings as areas: a pixel's area at least, and more of them far away than there is light
    const std::vector<float> ends = cell_ends(count - 1, middle, std::max(far, 2.0f * middle), 0.0f, [&](float r) {
        return std::min(std::pow(mean(narrowed.at(r)) * pixel_m * pixel_m, 0.75f), 1.0f) * r;
    });
    std::vector<DiscTap> taps;
    glm::vec3 total(1e-12f);
    for (int i = 0; i + 1 < count; ++i) {
        const float low = ends[size_t(i)], high = ends[size_t(i) + 1];
        constexpr int kParts = 16;
        float moment = 0.0f, sum = 0.0f;
        for (int j = 0; j < kParts; ++j) {
            const float x = low + (high - low) * (float(j) + 0.5f) / kParts, light = mean(narrowed.at(x)) * x;
            moment += light * x * x;
            sum += light;
        }
        const float r = sum > 0.0f ? std::sqrt(moment / sum) : 0.5f * (low + high), angle = kGoldenAngle * float(i);
        taps.push_back({r * glm::vec2(std::cos(angle), std::sin(angle)), narrowed.within(high) - narrowed.within(low)});
        total += taps.back().weight;
    }
    const glm::vec3 stays = middle_share(profile, taps, narrowed.within(middle), pixel_m);
    for (DiscTap& tap : taps) tap.weight *= (1.0f - stays) / total;
    taps.insert(taps.begin(), {glm::vec2(0.0f), stays});
    return taps;
}

}  // namespace tyndall::skin
