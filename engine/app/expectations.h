#pragma once
/// Judging captured pictures.

#include <map>
#include <string>
#include <vector>

#include "app/capture_file.h"
#include "image/image.h"

namespace tyndall {

/// One picture of a capture.
struct CapturedPicture {
    Image radiance;  ///< f32 RGB, scene-linear
    Image display;   ///< u8 RGB, display-encoded
};

/// The outcome of one expectation.
struct Verdict {
    enum class Outcome { held, failed, skipped } outcome = Outcome::held;
    std::string text;  ///< one line: what was measured against which limit, and why the limit
    Image heat_map;    ///< where it differs most; empty without a comparison
};

/// Judges all expectations of a capture on one camera's pictures, by variant name.
[[nodiscard]] std::vector<Verdict> judge(const CaptureFile& capture,
                                         const std::map<std::string, CapturedPicture>& pictures);

}  // namespace tyndall
