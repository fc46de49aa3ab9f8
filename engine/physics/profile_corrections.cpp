#include "physics/profile_corrections.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "physics/half_space.h"

namespace tyndall::physics {
namespace {

/// Limbs of half-spaces by what they let leave.
struct LimbTable {
    static constexpr int kSolids = 24;
    std::array<float, kSolids> leaving{}, limb{};

    explicit LimbTable(float eta) {
        const float grazing_inside = std::sqrt(1.0f - 1.0f / (eta * eta));
        for (int i = 0; i < kSolids; i += 3) {
            glm::vec3 albedo;
            for (int c = 0; c < 3; ++c) {
                const float t = 1.0f - float(i + c) / float(kSolids - 1);
                albedo[c] = 1.0f - t * t;  // more of them where little is absorbed
            }
            const HalfSpace solid(albedo, eta);
            const glm::vec3 more = solid.leaving(grazing_inside) - solid.leaving(1.0f);
            for (int c = 0; c < 3; ++c) {
                leaving[size_t(i + c)] = solid.diffuse_leaving()[c];
                limb[size_t(i + c)] = more[c] / std::max(leaving[size_t(i + c)], 1e-6f);
            }
        }
        limb[0] = limb[1];  // nothing leaves
    }

    [[nodiscard]] float at(float albedo) const {
        const size_t above = std::clamp<size_t>(
            size_t(std::lower_bound(leaving.begin(), leaving.end(), albedo) - leaving.begin()), 1, kSolids - 1);
        const float t = (albedo - leaving[above - 1]) / std::max(leaving[above] - leaving[above - 1], 1e-6f);
        return std::lerp(limb[above - 1], limb[above], std::clamp(t, 0.0f, 1.0f));
    }
};

}  // namespace

ProfileCorrections profile_corrections(const glm::vec3& albedo, const glm::vec3& spread_m, float eta) {
    const LimbTable limbs(eta);
    ProfileCorrections made;
    for (int c = 0; c < 3; ++c) {
        if (!(albedo[c] < 1.0f)) continue;
        const float x = 1.0f - std::sqrt(std::max(albedo[c], 0.0f));
        made.drift_m[c] = 1.55f * spread_m[c] * std::pow(eta, -2.3f) * (0.07f + 0.47f * x + 0.9f * std::pow(x, 6.0f));
        made.limb[c] = limbs.at(albedo[c]);
        made.convex_m[c] = spread_m[c] * (0.15f + 1.65f * x);
    }
    return made;
}

}  // namespace tyndall::physics
