#pragma once
/// From assembled texts to a linked program; for this floor's sources.

#include "gpu/shader_library.h"
#include "gpu/shader_source.h"

namespace tyndall::gpu {

/// Compiles and links. Throws Error with every message of every stage, placed in its file; `reads` then still tells
/// what was read.
[[nodiscard]] Program compile(const ShaderFiles& files, const ProgramDesc& desc, ShaderReads& reads);

}  // namespace tyndall::gpu
