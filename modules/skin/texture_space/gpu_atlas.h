#pragma once
/// An atlas on the GPU: lists of its texels for compute shaders (shaders/texture_space/atlas.glsl).

#include <string_view>
#include <vector>

#include "gpu/gpu.h"
#include "texture_space/atlas.h"
#include "texture_space/chunks.h"

namespace tyndall::skin {

/// Rows of this many entries.
inline constexpr int kListColumns = 1024;

struct GpuAtlas {
    GpuAtlas() = default;
    /// `surface`: with the places and normals too.
    GpuAtlas(const Atlas& atlas, bool surface);

    // Lists of covered texels have kChunkTexels for each chunk; what a chunk lacks is chart 0 at the map's corner,
    // which no chart and no gutter reaches.
    gpu::Texture steps;   ///< covered texels, then gutters without padding: TexelSteps, place on the map
    gpu::Texture charts;  ///< the same: number of the chart
    gpu::Texture taps;  ///< gutters, those next to covered texels and padding last: places on the map of the four that
                        ///< they are made of
    gpu::Texture weights;  ///< the same: of the first three taps, and the gutter's place on the map
    gpu::Texture gutter_charts;
    gpu::Texture places;   ///< covered texels: in the mesh's space, place on the map
    gpu::Texture normals;  ///< the same: in the mesh's space, as long as 1 + curvature (1/m), chart
    int extent = 0;
    int covered = 0;      ///< entries
    int gutters = 0;      ///< without padding
    int far_gutters = 0;  ///< of them, which come first: not within two texels of a covered one
    int padding = 0;

    /// A map of this atlas, black.
    [[nodiscard]] gpu::Texture make_map(std::string_view label, gpu::Format format = gpu::Format::rgba32f) const;
};

/// Chunks of an atlas' list that shaders are to work on.
class ChunkList {
 public:
    /// `set` chooses among those of covered texels; `gutters`: all of gutters too.
    void update(const GpuAtlas& atlas, const ChunkSet& set, bool gutters);
    /// For a program that includes atlas.glsl with CHUNKS.
    void dispatch(const gpu::Program& program) const;

 private:
    gpu::Texture list_;
    std::vector<float> numbers_;
    int count_ = 0;
    unsigned entries_ = 0;
};

/// A compute shader for `count` entries of a list, with what follows waiting for it.
void dispatch_list(int count);
/// Binds as an image, or as a texture without filter, whichever the program has.
void bind_list(const gpu::Program& program, std::string_view name, const gpu::Texture& texture);

}  // namespace tyndall::skin
