#pragma once
/// Volumes that change with time: files with a number in their names.

#include <cstdint>
#include <string>
#include <vector>

#include "image/volume.h"

namespace tyndall {

enum class Playback { loop, hold };

/// Files `first`, `first + step`, ... up to `last`, shown one after the other.
struct VolumeSequence {
    std::string file;  ///< the last run of # stands for the number, padded with zeros to as many digits
    GridChoice grid;
    int first = 1, last = 1, step = 1;
    float frames_per_s = 24.0f;  ///< of the files
    float start_s = 0.0f;        ///< scene time at which the first is shown
    Playback playback = Playback::loop;
    bool operator==(const VolumeSequence&) const = default;
};

/// How many files; at least one.
[[nodiscard]] int frame_count(const VolumeSequence& sequence);
/// Which of them is shown, from 0; the first before the start.
[[nodiscard]] int frame_at(const VolumeSequence& sequence, double time_s);
/// The index that is shown after `index`; itself where the sequence holds its last.
[[nodiscard]] int frame_after(const VolumeSequence& sequence, int index);
/// The file's name.
[[nodiscard]] std::string frame_name(const VolumeSequence& sequence, int index);

}  // namespace tyndall
