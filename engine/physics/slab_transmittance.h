#pragma once
/// How much light comes through thin parts of a solid: ears, nostrils, lips.

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "physics/multipole.h"

namespace tyndall::physics {

/// A slab `thickness_m` thick whose both sides are covered by all layers but the last, which fills what is between. One
/// that is too thin for it has the covers alone, each thinner in proportion.
[[nodiscard]] std::vector<SolidLayer> slab_of(std::span<const SolidLayer> layers, double thickness_m);

/// Of light that has entered a slab along the normal, the share that leaves its other side, by the slab's thickness, as
/// a table (layered_response). DiffusionProfile::through knows the profile alone and is no
/// substitute: at 3 mm of skin it is off by a tenth to nine tenths (docs/skin_profiles.md).
class SlabTransmittance {
 public:
    static constexpr size_t kEntries = 256;

    explicit SlabTransmittance(std::span<const SolidLayer> layers);

    /// Entry i is that of a thickness of reach_m (i / (kEntries - 1))^2.
    [[nodiscard]] const std::array<glm::vec3, kEntries>& values() const { return values_; }
    /// Where less than 1e-4 comes through, or 1 m.
    [[nodiscard]] float reach_m() const { return reach_m_; }
    /// Linear between entries; 0 beyond the reach.
    [[nodiscard]] glm::vec3 at(float thickness_m) const;
    /// Thicknesses times `lengths` (above 0), shares times `shares`.
    [[nodiscard]] SlabTransmittance scaled(float lengths, const glm::vec3& shares) const;

 private:
    std::array<glm::vec3, kEntries> values_{};
    float reach_m_ = 0.0f;
};

}  // namespace tyndall::physics
