#pragma once
/// What the pictures of a study's scene are held against.

#include <string>

#include "image/significance.h"
#include "measure/study.h"
#include "traced_reference.h"

namespace tyndall {

/// A reference, ready to be compared with.
struct Truth {
    NoisyPicture picture;  ///< of the scene's size; the variance may be empty
    std::string about;     ///< for people: samples, orders, or the file
    std::string identity;  ///< other text for another picture
    std::string problem;   ///< what went wrong with keeping it; for people
    bool complete = true;  ///< false: tracing it was cancelled
};

/// Loads the scene's reference, or traces what of it is not kept. Throws Error.
[[nodiscard]] Truth truth_of(const measure::Study& study, const measure::StudyScene& scene, const FilmCache& films,
                             const TraceWatch& watch);

/// "/pointer=value" texts in halves. Throws Error.
[[nodiscard]] Assignments assignments(const std::vector<std::string>& texts);

}  // namespace tyndall
