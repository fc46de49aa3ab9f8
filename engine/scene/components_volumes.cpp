#include <algorithm>

#include "core/error.h"
#include "scene/scattering_components.h"

namespace tyndall {
namespace {

Bounds box_of(const Volume& volume) {
    return {volume.low_m, volume.low_m + glm::vec3(volume.size) * volume.voxel_m};
}

/// From a box to [0, 1]^3 over a part of a file's space that fills it, or lies in its middle as large as its own
/// proportions allow.
glm::mat4 to_part(const Bounds& box, const glm::vec3& part_m, VolumeFit fit, const glm::mat4& local_to_world) {
    glm::vec3 extent = glm::max(box.size(), glm::vec3(1e-12f));
    if (fit == VolumeFit::contain) {
        glm::vec3 share;  // of the box's edge, before all shrink alike
        for (int axis = 0; axis < 3; ++axis) {
            const float edge_m = extent[axis] * glm::length(glm::vec3(local_to_world[axis]));
            share[axis] = part_m[axis] / std::max(edge_m, 1e-12f);
        }
        extent *= share / std::max({share.x, share.y, share.z});
    }
    glm::mat4 map(1.0f);
    for (int axis = 0; axis < 3; ++axis) {
        map[axis][axis] = 1.0f / extent[axis];
        map[3][axis] = 0.5f - box.centre()[axis] / extent[axis];
    }
    return map;
}

/// From [0, 1]^3 over a part of a file's space to [0, 1]^3 over a volume of it.
glm::mat4 to_volume(const Bounds& part, const Volume& volume) {
    glm::mat4 map(1.0f);
    const Bounds own = box_of(volume);
    for (int axis = 0; axis < 3; ++axis) {
        map[axis][axis] = part.size()[axis] / own.size()[axis];
        map[3][axis] = (part.low[axis] - own.low[axis]) / own.size()[axis];
    }
    return map;
}

/// A grid of the file, moving as the scene says.
GridChoice moving(const VolumeDensity& from, const std::string& grid) {
    GridChoice choice(grid);
    if (from.motion_blur.shutter_s > 0.0f) choice.velocity = from.motion_blur.grid;
    if (!choice.velocity.empty()) choice.shutter_s = from.motion_blur.shutter_s;
    return choice;
}

VolumeSequence sequence_of(const VolumeDensity& from, const std::string& grid) {
    const SequenceChoice& choice = from.sequence;
    if (choice.last < choice.first) throw Error("a sequence's last frame must not be before its first");
    VolumeSequence sequence{.file = from.file, .grid = moving(from, grid)};
    sequence.first = choice.first, sequence.last = choice.last, sequence.step = choice.step;
    sequence.frames_per_s = choice.frames_per_s, sequence.start_s = choice.start_s, sequence.playback = choice.playback;
    return sequence;
}

bool is_sequence(const VolumeDensity& from) {
    return from.file.find('#') != std::string::npos;
}

/// The part of the file's space that is shown: what the scene says, or the density's box; of a sequence, in its last
/// frame, since most things that flow spread. Null while that is on its way.
std::shared_ptr<const VolumeAsset> shown_volume(const VolumeDensity& from, AssetStore& assets) {
    if (!is_sequence(from)) return assets.volume(from.file, moving(from, from.grid));
    const VolumeSequence sequence = sequence_of(from, from.grid);
    VolumeSequence last = sequence;
    last.first = sequence.first + (frame_count(sequence) - 1) * sequence.step;
    return assets.sequence_frame(last, 0);
}

}  // namespace

void describe(StructBuilder<SequenceChoice>& d) {
    using S = SequenceChoice;
    d.doc("Which files a sequence has: the last run of # in the file's name stands for the number.");
    d.field("first", &S::first, "The first file's number.").range(0, 999999);
    d.field("last", &S::last, "The last file's number.").range(0, 999999);
    d.field("step", &S::step, "From one file's number to the next one's.").range(1, 10000);
    d.field("frames_per_s", &S::frames_per_s, "Files shown in a second.").unit("1/s").range(1e-3, 1000.0);
    d.field("start_s", &S::start_s, "When the first is shown.").unit("s").range(-1e6, 1e6);
    d.field("playback", &S::playback, "After the last comes the first again, or it stays.", {"loop", "hold"});
}

void describe(StructBuilder<MotionBlur>& d) {
    d.doc("What moves blurs while the shutter is open.");
    d.field("grid", &MotionBlur::grid,
            "Grid of velocities of the OpenVDB file, in its own units a second; empty = still.");
    d.field("shutter_s", &MotionBlur::shutter_s, "How long the shutter is open.").unit("s").range(0.0, 100.0);
}

void describe(StructBuilder<VolumeDensity>& d) {
    using V = VolumeDensity;
    d.doc("A grid of voxels from a file, linear between them.");
    d.field(
         "file", &V::file,
         "An OpenVDB file, or a JSON description of a raw one, relative to the scene; with # for digits, a sequence.")
        .asset("volume");
    d.field("grid", &V::grid, "Which grid of an OpenVDB file; empty = density.");
    d.field("scale", &V::scale, "Multiplies its values.").range(0.0, 1e9);
    d.field("fit", &V::fit, "stretch fills the box; contain keeps the voxels' proportions.", {"stretch", "contain"});
    d.field("low_m", &V::low_m, "With high_m: the part of the file's own space that is shown; both 0 = the grid's box.")
        .range(-1e9, 1e9);
    d.field("high_m", &V::high_m, "See low_m.").range(-1e9, 1e9);
    d.field("sequence", &V::sequence, "For a file with # in its name.");
    d.field("motion_blur", &V::motion_blur, "Blurs the grid along its velocities, for a still as for a sequence.");
}

GridDensity placed_volume(const VolumeDensity& from, const std::string& grid, AssetStore& assets,
                          const VolumePlace& place) {
    if (from.file.empty()) throw Error("a density from a volume needs a file");
    GridDensity made{nullptr, glm::mat4(1.0f), from.scale};
    std::shared_ptr<const VolumeAsset> volume;
    if (is_sequence(from)) {
        const VolumeSequence sequence = sequence_of(from, grid);
        volume = assets.sequence_frame(sequence, frame_at(sequence, place.time_s));
    } else {
        volume = assets.volume(from.file, moving(from, grid));
    }
    if (!volume) return made;
    Bounds part{from.low_m, from.high_m};
    if (from.low_m == from.high_m) {
        const auto shown = shown_volume(from, assets);
        if (!shown) return made;
        part = box_of(shown->volume);
    }
    if (part.empty()) throw Error("a volume's high_m must be above its low_m");
    made.volume = std::move(volume);
    made.to_volume = to_part(place.box, part.size(), from.fit, place.local_to_world);
    if (const Bounds own = box_of(made.volume->volume); own.low != part.low || own.high != part.high)
        made.to_volume = to_volume(part, made.volume->volume) * made.to_volume;
    return made;
}

}  // namespace tyndall
