#pragma once
/// Evaluating and bounding density fields on the CPU.

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "geometry/bounds.h"
#include "scene/scattering.h"

namespace tyndall {

/// A density field at one moment, ready for many lookups. Holds what the field shares.
class DensityEvaluator {
 public:
    /// `local_to_world` as of the medium's box or the interior's mesh; `time_s` is the scene's.
    DensityEvaluator(DensityField field, const glm::mat4& local_to_world, double time_s);

    /// 1 everywhere: no lookups are needed.
    [[nodiscard]] bool constant() const { return std::holds_alternative<ConstantDensity>(field_); }
    /// At a place in local space; never negative, finite.
    [[nodiscard]] float at(const glm::vec3& local) const;
    /// No value inside a local box is above this.
    [[nodiscard]] float upper_bound(const Bounds& local) const;

 private:
    DensityField field_;
    glm::mat4 local_to_world_;
    double time_s_;
};

}  // namespace tyndall
