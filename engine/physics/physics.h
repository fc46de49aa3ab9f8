#pragma once
/// The physics of this folder's .glsl files as C++: the same text, compiled with GLM in tyndall::physics.
///
/// The files keep to what both languages share: plain functions and structs, literals with f, no swizzles but
/// .x .y .z .w, FN before a function, OUT(T) and INOUT(T) for what a function gives back. Their comments are the
/// manual.

#include <glm/glm.hpp>

#define FN inline
#define OUT(T) T&
#define INOUT(T) T&
namespace tyndall::physics {
using namespace glm;
using glm::log;  // beside the namespace tyndall::log
#include "physics/all.glsl"
}  // namespace tyndall::physics
#undef FN
#undef OUT
#undef INOUT
