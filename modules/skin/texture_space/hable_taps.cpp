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

/// The taps lie in the middle and on rings about it: this many units away ends what those before stand for. With d'Eon
/// & Luebke's skin the red weights of the rings are as published.
constexpr std::array<float, 2> kRingEnds{1.2f, 3.05f};

size_t ring_of(const HableTap& published) {
    const float distance = glm::length(published.offset);
    return distance < kRingEnds[0] ? 0 : distance < kRingEnds[1] ? 1 : 2;
}

/// Metres within which three quarters of the light of the channel that spreads farthest leave.
float three_quarters_within(const physics::DiffusionProfile& profile) {
    float low = 0.0f, high = 1.0f;
    for (int i = 0; i < 40; ++i) {
        const float middle = 0.5f * (low + high);
        const glm::vec3 share = profile.within(middle);
        (std::min({share.x, share.y, share.z}) < 0.75f ? low : high) = middle;
    }
    return high;
}

/// The root of the mean square distance that light of all channels goes that leaves on each ring, metres.
std::array<float, 3> ring_radii(const physics::DiffusionProfile& profile, float unit) {
    const auto sums = [&](float r) {  // of light within, and of it times its distance squared
        glm::vec2 sum(0.0f);
        for (const physics::DiffusionLobe& lobe : profile.lobes) {
            const float v = lobe.variance_m2, left = std::exp(-r * r / (2.0f * v));
            const float weight = lobe.weight.x + lobe.weight.y + lobe.weight.z;
            sum += weight * glm::vec2(1.0f - left, 2.0f * v - (r * r + 2.0f * v) * left);
        }
        return sum;
    };
    const glm::vec2 near = sums(kRingEnds[0] * unit), nearer = sums(kRingEnds[1] * unit), all = sums(1.0f);
    const auto radius = [](const glm::vec2& ring) { return std::sqrt(ring.y / std::max(ring.x, 1e-12f)); };
    return {radius(near), radius(nearer - near), radius(all - nearer)};
}

/// Whether it is `skin` at another scale.
bool is_scaled(const physics::DiffusionProfile& profile, const physics::DiffusionProfile& skin, float scale) {
    if (profile.lobes.size() != skin.lobes.size()) return false;
    for (size_t i = 0; i < skin.lobes.size(); ++i) {
        const float ratio = profile.lobes[i].variance_m2 / (skin.lobes[i].variance_m2 * scale * scale);
        if (std::abs(ratio - 1.0f) > 0.01f || glm::distance(profile.lobes[i].weight, skin.lobes[i].weight) > 1e-3f)
            return false;
    }
    return true;
}

}  // namespace

std::array<HableTap, kHableTaps> hable_taps(const physics::DiffusionProfile& profile) {
    const physics::DiffusionProfile skin = physics::six_gaussian_skin();
    const float scale = three_quarters_within(profile) / three_quarters_within(skin);
    const bool published = is_scaled(profile, skin, scale);
    const float unit = kHableUnit_m * scale;
    const glm::vec3 near = profile.within(kRingEnds[0] * unit), nearer = profile.within(kRingEnds[1] * unit);
    const std::array<glm::vec3, 3> rings{near, nearer - near, 1.0f - nearer};
    std::array<float, 3> ring_sums{};
    glm::vec3 sum(0.0f);
    for (const HableTap& tap : kPublished) {
        ring_sums[ring_of(tap)] += tap.weight.x;
        sum += tap.weight;
    }
    const std::array<float, 3> radii = ring_radii(profile, unit), skin_radii = ring_radii(skin, kHableUnit_m);
    std::array<HableTap, kHableTaps> taps = kPublished;
    for (HableTap& tap : taps) {
        const size_t ring = ring_of(tap);
        tap.weight = published ? tap.weight / sum : tap.weight.x / ring_sums[ring] * rings[ring];
        tap.offset *= published ? unit : kHableUnit_m * radii[ring] / std::max(skin_radii[ring], 1e-12f);
    }
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
