#pragma once
/// What lies behind the froxels' grid.

#include <optional>
#include <vector>

#include "froxels/froxel_volume.h"
#include "media_buffer.h"
#include "media_programs.h"
#include "render/frame_graph.h"

namespace tyndall::participating_media {

/// A bit for each medium that has a term of this source (and light, if it is one).
[[nodiscard]] unsigned media_bits(const std::vector<Term>& terms, Term::Source source, size_t light = 0);
/// The phase function that all of these terms' media have; none when they differ.
[[nodiscard]] std::optional<PhaseKind> common_phase(const MediaBuffer& media, const std::vector<Term>& terms);

/// Draws the froxels' terms between the grid's end and each pixel's surface, in pieces with closed forms.
class FroxelBeyond {
 public:
    /// The targets are bound and add.
    void draw(PassContext& context, const MediaBuffer& media, const FroxelVolume& volume, int light_steps);

 private:
    void draw_light(PassContext& context, const MediaBuffer& media, const FroxelVolume& volume, int light_steps,
                    size_t light);
    MediaPrograms lights_{
        {.name = "participating_media.froxels.beyond", .fragment = "participating_media/froxels/beyond_light.frag"}};
};

}  // namespace tyndall::participating_media
