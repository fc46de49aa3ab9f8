#pragma once
/// What of media does not fit a uniform block: grids and tables of phase functions.

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <string>
#include <vector>

#include "gpu/gpu.h"
#include "scene/render_scene.h"

namespace tyndall::participating_media {

/// All grids' voxels together are at most so many bytes on the GPU; larger ones are halved until they fit.
inline constexpr int64_t kMostGridBytes = int64_t{1} << 30;

/// The mask physics::blue_noise_mask() as a texture.
[[nodiscard]] gpu::Texture make_blue_noise();

/// Keeps the textures until other grids or tables are asked for.
class MediaTextures {
 public:
    /// Uploads what these media need. Returns what could not be shown as it is, or nothing.
    std::string update(const std::vector<const Medium*>& media);
    /// Where a grid of the last update lies in the atlas: voxels along x, y and z, and its first layer.
    [[nodiscard]] glm::vec4 place(const VolumeAsset& volume) const;
    /// All grids' voxels, stacked along z; a single empty voxel without any.
    [[nodiscard]] const gpu::Texture& grids() const { return grids_; }
    /// A row for each medium, 1/sr over the scattering angle from 0 to pi.
    [[nodiscard]] const gpu::Texture& phase_tables() const { return phase_tables_; }

 private:
    /// A part of the atlas. It may be larger than its grid, so that a sequence's next frame fits as well.
    struct Slot {
        std::shared_ptr<const VolumeAsset> volume;
        glm::ivec3 room{0};
        glm::ivec3 size{0};  ///< of the grid in it, which may have been halved
        int first_layer = 0;
    };
    std::string place_grids(std::vector<std::shared_ptr<const VolumeAsset>> volumes);
    bool replace_grids(const std::vector<std::shared_ptr<const VolumeAsset>>& volumes);
    void upload(Slot& slot);
    void fill_tables(const std::vector<const Medium*>& media);

    std::vector<Slot> slots_;
    int halvings_ = 0;
    std::vector<uint64_t> tables_;  ///< ids of the media's tables; 0 = none
    gpu::Texture grids_, phase_tables_;
};

}  // namespace tyndall::participating_media
