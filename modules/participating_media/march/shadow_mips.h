#pragma once
/// Least depths over parts of the shadow maps, for rays that skip what is dark.

#include <cstdint>
#include <vector>

#include "gpu/gpu.h"
#include "render/frame.h"

namespace tyndall::participating_media {

/// A pyramid over the pages of the shadow maps: each texel of its first level has the least and largest depth of 8x8
/// texels of a page, those above of 2x2 below. Made again when a view was.
class ShadowMips {
 public:
    /// False when there are no shadow maps.
    bool update(const Frame& frame);
    void bind(const gpu::Program& program) const;

 private:
    gpu::Texture mips_;
    std::vector<uint64_t> versions_;  ///< of the views that it was made from
};

}  // namespace tyndall::participating_media
