#pragma once
/// What GL calls a Format; for this floor's sources alone.

#include "gpu/gpu.h"

namespace tyndall::gpu {

/// The GL names of a texel format.
struct FormatInfo {
    std::string_view name;
    size_t bytes;           ///< of one texel, tightly packed
    unsigned int internal;  ///< sized internal format
    unsigned int external;  ///< channels of upload()
    unsigned int type;      ///< type of upload()
};
[[nodiscard]] const FormatInfo& info(Format format);

}  // namespace tyndall::gpu
