#pragma once
/// What share of the light goes through bodies of the technique thickness, pixel by pixel.

#include "body_space.h"
#include "gpu/gpu.h"
#include "radial_kernel.h"
#include "render/kept.h"
#include "seen_surface.h"

namespace tyndall::translucency {

/// Share of light that leaves farther away than a distance: of an even plane, what the kernel has beyond it. A row,
/// over the root of the distance over the farthest: so many columns that the nearest will do.
[[nodiscard]] gpu::Texture table_of_passing(const Optics& optics, Model model, float farthest_m);

/// Thickness grids of meshes, each made once for a shape (Barre-Brisebois & Bouchard 2011).
class ThicknessShares {
 public:
    /// In Pass::execute of a pass that writes `target` (rgba16): fills the surface's pixels. False for a mesh without
    /// area, which has no thickness.
    bool draw(PassContext& context, const SeenSurface& seen, std::string_view target, const gpu::Texture& passing,
              float farthest_m);
    void end_frame() { grids_.end_frame(); }

 private:
    struct Grid {
        gpu::Texture texture;
        glm::mat4 grid_from_shape{1.0f};  ///< from the stretched mesh's space
        glm::vec3 shape{1.0f};
        bool made = false;
    };

    const Grid& grid_of(const Surface& surface);

    Kept<ShapeKey, Grid> grids_;
};

}  // namespace tyndall::translucency
