#include "texture_space/hable_taps.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace tyndall::skin {
namespace {

/// As printed (Livermore, Real-time Scattering, 2012, 4.3.1); offsets in units of their own.
constexpr std::array<HableTap, kHableTaps> kPublished{{{{0.000000f, 0.000000f}, {0.220441f, 0.437000f, 0.635000f}},
                                                       {{1.633992f, 0.036795f}, {0.076356f, 0.064487f, 0.039097f}},
                                                       {{0.177801f, 1.717593f}, {0.116515f, 0.103222f, 0.064912f}},
                                                       {{-0.194906f, 0.091094f}, {0.064844f, 0.086388f, 0.062272f}},
                                                       {{-0.239737f, -0.220217f}, {0.131798f, 0.151695f, 0.103676f}},
                                                       {{-0.003530f, -0.118219f}, {0.025690f, 0.042728f, 0.033003f}},
                                                       {{1.320107f, -0.181542f}, {0.048593f, 0.064740f, 0.046131f}},
                                                       {{5.970690f, 0.253378f}, {0.048092f, 0.003042f, 0.000400f}},
                                                       {{-1.089250f, 4.958349f}, {0.048845f, 0.005406f, 0.001222f}},
                                                       {{-4.015465f, 4.156699f}, {0.051322f, 0.006034f, 0.001420f}},
                                                       {{-4.063099f, -4.110150f}, {0.061428f, 0.009152f, 0.002511f}},
                                                       {{-0.638605f, -6.297663f}, {0.030936f, 0.002868f, 0.000652f}},
                                                       {{2.542348f, -3.245901f}, {0.073580f, 0.023239f, 0.009703f}}}};

}  // namespace

std::array<HableTap, kHableTaps> hable_taps(const physics::DiffusionProfile& profile) {
    const glm::vec3 spread = profile.mean_square() / physics::six_gaussian_skin().mean_square();
    const float most = std::max({spread.x, spread.y, spread.z, 1e-12f});
    glm::vec3 sum(0.0f);
    for (const HableTap& tap : kPublished) sum += tap.weight;
    std::array<HableTap, kHableTaps> taps = kPublished;
    glm::vec3 outside(0.0f);
    for (int i = 1; i < kHableTaps; ++i) {
        HableTap& tap = taps[size_t(i)];
        tap.offset *= kHableUnit_m * std::sqrt(most);
        tap.weight *= spread / (most * sum);
        outside += tap.weight;
    }
    taps[0].weight = 1.0f - outside;
    return taps;
}

std::vector<HableTap> merged(const std::array<HableTap, kHableTaps>& taps, float distance) {
    std::vector<HableTap> result;
    for (const HableTap& tap : taps) {
        const auto near = std::ranges::find_if(
            result, [&](const HableTap& other) { return glm::distance(other.offset, tap.offset) < distance; });
        if (near == result.end()) {
            result.push_back(tap);
            continue;
        }
        const float there = near->weight.x + near->weight.y + near->weight.z;
        const float more = tap.weight.x + tap.weight.y + tap.weight.z;
        near->offset = glm::mix(near->offset, tap.offset, more / (there + more));
        near->weight += tap.weight;
    }
    return result;
}

glm::vec3 hable_edge(const std::array<HableTap, kHableTaps>& taps, const glm::vec2& direction, float x) {
    glm::vec3 lit(0.0f);
    for (const HableTap& tap : taps)
        if (x + glm::dot(tap.offset, direction) > 0.0f) lit += tap.weight;
    return lit;
}

}  // namespace tyndall::skin
