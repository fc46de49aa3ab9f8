#pragma once
/// Phase functions ready for many evaluations and samples.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "physics/physics.h"
#include "scene/scattering.h"

namespace tyndall::reference {

/// A phase function, per channel: only tables differ between channels.
class Phase {
 public:
    explicit Phase(const PhaseFunction& function);
    /// 1/sr, at the cosine between where light travels before and after.
    [[nodiscard]] glm::vec3 evaluate(float u) const {
        return cdf_.empty() ? glm::vec3(physics::phase_evaluate(kind_, parameters_, u)) : tabulated(u);
    }
    /// A cosine; the direction's density is `pdf`.
    [[nodiscard]] float sample(glm::vec2 xi) const {
        return cdf_.empty() ? physics::phase_sample(kind_, parameters_, xi) : sample_table(xi.x);
    }
    /// 1/sr. Of tables: the mean of the channels.
    [[nodiscard]] float pdf(float u) const {
        if (cdf_.empty()) return physics::phase_evaluate(kind_, parameters_, u);
        const glm::vec3 value = tabulated(u);
        return (value.x + value.y + value.z) / 3.0f;
    }

 private:
    [[nodiscard]] glm::vec3 tabulated(float u) const;
    [[nodiscard]] float sample_table(float xi) const;

    int kind_;
    glm::vec4 parameters_;
    std::vector<glm::vec3> values_;
    std::vector<double> cdf_;  ///< of the channels' mean, over the table's angles
};

}  // namespace tyndall::reference
