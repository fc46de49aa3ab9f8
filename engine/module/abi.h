#pragma once
/// The ABI tag: a digest of all the engine's public headers, made by the build. A module that was compiled with other
/// headers is refused.

#include "tyndall_abi_tag.h"

namespace tyndall {

/// TYNDALL_ABI_TAG that libtyndall was compiled with.
[[nodiscard]] const char* abi_tag();

}  // namespace tyndall
