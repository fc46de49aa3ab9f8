#pragma once
/// What lies behind the froxels' grid.

#include <map>
#include <string>
#include <vector>

#include "froxels/froxel_volume.h"
#include "media_buffer.h"
#include "render/frame_graph.h"
#include "render/light_programs.h"

namespace tyndall::participating_media {

/// A bit for each medium that has a term of this source (and light, if it is one).
[[nodiscard]] unsigned media_bits(const std::vector<Term>& terms, Term::Source source, size_t light = 0);
/// Defines for shaders/froxels/scattering.glsl by what is known of the media.
[[nodiscard]] std::vector<std::string> media_defines(const MediaBuffer& media, const std::vector<Term>& terms);
/// Programs by their defines.
class LightProgramSet {
 public:
    /// `base` is completed by the defines.
    explicit LightProgramSet(gpu::ProgramDesc base) : base_(std::move(base)) {}
    [[nodiscard]] LightPrograms& with(std::vector<std::string> defines);

 private:
    gpu::ProgramDesc base_;
    std::map<std::string, LightPrograms> programs_;
};

/// Draws the froxels' terms between the grid's end and each pixel's surface, in pieces with closed forms.
class FroxelBeyond {
 public:
    /// The targets are bound and add.
    void draw(PassContext& context, const MediaBuffer& media, const FroxelVolume& volume, int light_steps);

 private:
    void draw_light(PassContext& context, const MediaBuffer& media, const FroxelVolume& volume, int light_steps,
                    size_t light);
    LightProgramSet lights_{
        {.name = "participating_media.froxels.beyond", .fragment = "participating_media/froxels/beyond_light.frag"}};
};

}  // namespace tyndall::participating_media
