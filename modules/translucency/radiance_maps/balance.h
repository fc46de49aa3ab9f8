#pragma once
/// How a kernel of flat ground fits a closed body.

#include <glm/vec3.hpp>
#include <vector>

#include "geometry/mesh.h"
#include "radial_kernel.h"

namespace tyndall::translucency {

/// What the kernel is multiplied by at a mesh's vertices, at both ends of the light's way, so that every place sends
/// out all of its light and receives as much. A kernel of flat ground alone loses what would leave beyond the body's
/// end. Symmetric, so reciprocity stays (as shaders/points/balance.comp, on the CPU and for few points).
[[nodiscard]] std::vector<glm::vec3> balance(const Mesh& mesh, const Optics& optics, Model model, float metres_of_unit);

}  // namespace tyndall::translucency
