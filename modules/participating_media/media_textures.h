#pragma once
/// What of media does not fit a uniform block: grids and tables of phase functions.

#include <cstdint>
#include <memory>
#include <vector>

#include "gpu/gpu.h"
#include "scene/render_scene.h"

namespace tyndall::participating_media {

/// The mask physics::blue_noise_mask() as a texture.
[[nodiscard]] gpu::Texture make_blue_noise();

/// Keeps the textures until other grids or tables are asked for.
class MediaTextures {
 public:
    /// Uploads what these media need.
    void update(const std::vector<Medium>& media);
    /// The first layer of a grid in the atlas; it must be one of the last update's.
    [[nodiscard]] int first_layer(const VolumeAsset& volume) const;
    /// All grids' voxels, stacked along z; a single empty voxel without any.
    [[nodiscard]] const gpu::Texture& grids() const { return grids_; }
    /// A row for each medium, 1/sr over the scattering angle from 0 to pi.
    [[nodiscard]] const gpu::Texture& phase_tables() const { return phase_tables_; }

 private:
    void stack_grids();
    void fill_tables(const std::vector<Medium>& media);

    std::vector<std::shared_ptr<const VolumeAsset>> volumes_;
    std::vector<int> layers_;
    std::vector<uint64_t> tables_;  ///< ids of the media's tables; 0 = none
    gpu::Texture grids_, phase_tables_;
};

}  // namespace tyndall::participating_media
