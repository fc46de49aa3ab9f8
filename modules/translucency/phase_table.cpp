#include "phase_table.h"

#include <algorithm>
#include <cmath>

#include "physics/physics.h"

namespace tyndall::translucency {
namespace {

constexpr int kColumns = 1024;  ///< as in shaders/phase_table.glsl

bool same_phase(const PhaseFunction& a, const PhaseFunction& b) {
    return a.kind == b.kind && a.parameters == b.parameters && a.table == b.table;
}

}  // namespace

std::vector<glm::vec4> phase_row(const PhaseFunction& phase, int columns) {
    std::vector<glm::vec4> row(static_cast<size_t>(columns));
    for (size_t i = 0; i < row.size(); ++i) {
        const float share = static_cast<float>(i) / static_cast<float>(columns - 1);
        if (phase.kind == PhaseKind::tabulated && phase.table) {
            const std::vector<glm::vec3>& values = phase.table->values;
            const float at = share * static_cast<float>(values.size() - 1);
            const size_t low = std::min(static_cast<size_t>(at), values.size() - 2);
            row[i] = glm::vec4(glm::mix(values[low], values[low + 1], at - static_cast<float>(low)), 0.0f);
        } else {
            row[i] = glm::vec4(physics::phase_evaluate(static_cast<int>(phase.kind), phase.parameters,
                                                       std::cos(physics::kPi * share)));
        }
    }
    return row;
}

void PhaseTexture::update(const PhaseFunction& phase) {
    if (phase_ && same_phase(*phase_, phase)) return;
    phase_ = phase;
    const std::vector<glm::vec4> row = phase_row(phase, kColumns);
    if (texture_.name() == 0)
        texture_ = gpu::Texture({.format = gpu::Format::rgba32f, .width = kColumns}, "translucency.phase");
    texture_.upload(0, 0, row.data());
    most_ = glm::vec4(1e-6f);
    for (const glm::vec4& value : row) most_ = glm::max(most_, value);
}

void PhaseTexture::bind(const gpu::Program& program) const {
    program.texture("phase_table", texture_, {.filter = gpu::Filter::linear});
}

}  // namespace tyndall::translucency
