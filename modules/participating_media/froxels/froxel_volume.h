#pragma once
/// What the froxels of a frame hold, for the pass that makes it and for programs that read it.

#include "froxels/froxel_grid.h"
#include "gpu/gpu.h"

namespace tyndall::participating_media {

struct FroxelVolume {
    FroxelGrid grid;
    bool active = false;     ///< the plan has terms for the froxels in this frame
    gpu::Texture columns;    ///< shaders/froxels/columns.comp
    gpu::Texture reach;      ///< shaders/froxels/reach.comp
    gpu::Texture source[2];  ///< radiance per metre, a the weight: this frame's and the last one's
    int now = 0;             ///< which of the two is this frame's
    gpu::Texture radiance;   ///< shaders/froxels/integrate.comp

    /// Slices of a column that a thread of the compute shaders goes through.
    [[nodiscard]] int slices_a_thread() const;
    /// Makes the textures for the grid's size; true when they are new. `history` = both sources are needed.
    bool make(bool history);
    /// Sets what shaders/froxels/read.glsl declares, and whether there are froxels.
    void bind(const gpu::Program& program);
    /// Sets what shaders/froxels/grid.glsl declares.
    void bind_grid(const gpu::Program& program) const;
};

}  // namespace tyndall::participating_media
