#pragma once
/// Judging captured pictures.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/capture_file.h"
#include "image/image.h"
#include "image/significance.h"

namespace tyndall {

/// One picture of a capture.
struct CapturedPicture {
    Image radiance;  ///< f32 RGB, scene-linear
    Image display;   ///< u8 RGB, display-encoded
};

/// What stands behind a picture that another is held against.
enum class Backing {
    truth,     ///< traced, or from the folder of references
    baseline,  ///< an earlier picture: no truth backs it
    variant    ///< another variant of the capture
};

/// A number that was held against a limit.
struct MeasuredLimit {
    std::string metric;  ///< as docs/compare.md calls it
    double value = 0.0, limit = 0.0;
    bool at_least = false;  ///< the value must not be below the limit, otherwise not above it
    bool held = true;
};

/// Two pictures that were held against each other, as they were compared: cropped and filtered.
struct Compared {
    Backing backing = Backing::truth;
    std::string with;        ///< the other picture's name
    NoisyPicture reference;  ///< without a variance where none is known
    Image test;
    std::vector<MeasuredLimit> limits;
};

/// The outcome of one expectation.
struct Verdict {
    enum class Outcome { held, failed, skipped } outcome = Outcome::held;
    std::string text;                ///< one line: what was measured against which limit, and why the limit
    Image heat_map;                  ///< where it differs most; empty without a comparison
    std::vector<Compared> compared;  ///< all that the expectation holds the picture against
};

/// The file of a reference: beside `folder`'s files, or of "references:NAME" in the folder that TYNDALL_REFERENCES
/// names; nothing when that folder is not there. Throws Error when the file does not exist, with the nearest name.
[[nodiscard]] std::optional<std::filesystem::path> reference_picture(const std::filesystem::path& folder,
                                                                     const std::string& name);

/// Judges all expectations of a capture on one camera's pictures, by variant name; `camera` is the one that variants
/// without a camera of their own were seen through, empty for the scene's choice. Expectations whose traced reference
/// shows another camera's view are skipped.
[[nodiscard]] std::vector<Verdict> judge(const CaptureFile& capture,
                                         const std::map<std::string, CapturedPicture>& pictures,
                                         const std::string& camera = {});

}  // namespace tyndall
