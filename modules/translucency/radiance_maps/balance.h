#pragma once
/// How a kernel of flat ground fits a closed body.

#include <glm/vec3.hpp>
#include <vector>

#include "geometry/mesh.h"
#include "radial_kernel.h"

namespace tyndall::translucency {

/// What is known at a place of the surface.
struct Balanced {
    glm::vec3 scale{1.0f};  ///< what the kernel is multiplied by
    // Of light that leaves here, if all is lit evenly:
    glm::vec3 own{1.0f};     ///< share that has entered in the same piece of the surface, a channel each
    glm::vec3 others{0.0f};  ///< sum of the normals where the rest has entered, by its share; the mean of the channels
    glm::vec3 sizes{1.0f};   ///< of that sum for each channel, over the mean's
};

/// What the kernel is multiplied by at a mesh's vertices, at both ends of the light's way, so that every place sends
/// out all of its light and receives as much. A kernel of flat ground alone loses what would leave beyond the body's
/// end. Symmetric, so reciprocity stays (as shaders/points/balance.comp, on the CPU and for few points). With the
/// scaling `published` all scales are 1.
[[nodiscard]] std::vector<Balanced> balance(const Mesh& mesh, const Optics& optics, Model model, Scaling scaling,
                                            float metres_of_unit);

}  // namespace tyndall::translucency
