#pragma once
/// A phase function as a texture: shaders/phase_table.glsl.

#include <glm/vec4.hpp>
#include <optional>
#include <vector>

#include "gpu/gpu.h"
#include "scene/scattering.h"

namespace tyndall::translucency {

/// Values of a phase function over the scattering angle, the first forward, 1/sr.
[[nodiscard]] std::vector<glm::vec4> phase_row(const PhaseFunction& phase, int columns);

class PhaseTexture {
 public:
    /// Makes it anew when the phase function has changed.
    void update(const PhaseFunction& phase);
    void bind(const gpu::Program& program) const;
    /// The function's largest value, 1/sr.
    [[nodiscard]] const glm::vec4& most() const { return most_; }

 private:
    std::optional<PhaseFunction> phase_;
    glm::vec4 most_{0.0f};
    gpu::Texture texture_;
};

}  // namespace tyndall::translucency
