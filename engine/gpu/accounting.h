#pragma once
/// The tally behind alive(); for this floor's sources alone.

#include "gpu/gpu.h"

namespace tyndall::gpu {

/// The one tally; objects add themselves when made and subtract when destroyed, on the context's thread.
[[nodiscard]] Alive& tally();
/// Names a GL object for debuggers and messages.
void set_label(unsigned int kind, unsigned int name, std::string_view label);

}  // namespace tyndall::gpu
