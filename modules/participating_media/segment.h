#pragma once
/// What the provider of the media-segment seam gives to programs.

#include "froxels/froxel_volume.h"
#include "media_buffer.h"
#include "media_settings.h"
#include "render/frame_graph.h"

namespace tyndall::participating_media {

/// So many pairs of a source and a medium are rendered before a surface; the rest is left out there, with a warning.
inline constexpr size_t kMaximumSegmentTerms = 64;

/// Sets what shaders/segment.glsl declares.
void bind_segment(const gpu::Program& program, PassContext& context, MediaBuffer& media, FroxelVolume& froxels,
                  const MediaSettings& settings);

}  // namespace tyndall::participating_media
