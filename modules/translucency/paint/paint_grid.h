#pragma once
/// What paint does to light that goes in and out of a body, about each place of its surface.

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "geometry/mesh.h"
#include "radial_kernel.h"

namespace tyndall::translucency {

/// What is painted over a body; the texture's alpha multiplies the cover.
struct Paint {
    float cover = 0.0f;
    glm::vec3 colour{1.0f};
    TextureSlot texture;
};
[[nodiscard]] Paint paint_of(const Material& boundary);

/// The body under the paint.
struct PaintedBody {
    Optics optics;
    Model model{};
    float metres = 1.0f;  ///< of a unit of the mesh's
    float radius = 0.0f;  ///< metres: 3 volume over surface; 0 = endless
};

/// Near the surface, in voxels, x first.
///
/// Light inside that meets paint is thrown back into the body and leaves elsewhere: what leaves where the surface is
/// open is more than the open share. Let G be the open share that a place hears of (the mean over the kernel), q what
/// paint absorbs over what the boundary lets out of light that meets it from inside, and a what the body absorbs over
/// what it gives back where there is no paint. Of even light then T = G (1 + a) / (a + G + (1 - G) q) leaves. The
/// kernel is scaled at both ends, which keeps reciprocity, so that T is what it gives.
struct PaintGrid {
    Bounds box;
    glm::ivec3 size{0};
    std::vector<glm::vec4> ends;  ///< rgb what the kernel is multiplied by at both ends; a open share of the surface
    std::vector<glm::vec4> even;  ///< rgb T

    [[nodiscard]] bool empty() const { return ends.empty(); }
};

/// `resolution` voxels along the longest side. Empty for a mesh without area.
[[nodiscard]] PaintGrid make_paint_grid(const Mesh& mesh, const Paint& paint, const PaintedBody& body, int resolution);

}  // namespace tyndall::translucency
