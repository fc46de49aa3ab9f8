#pragma once
/// Tells shaders which kinds of media a frame has, so that they are compiled for no others.

#include <string>
#include <vector>

#include "scene/render_scene.h"

namespace tyndall::participating_media {

/// How shadows of uneven media are found by some light of the frame.
struct ShadowKinds {
    bool marched = false, opacity = false, fourier = false, clipmap = false;
};

/// The text that stands for shaders/media_kinds.glsl (ShaderLibrary::set_text).
[[nodiscard]] std::string media_kinds(const std::vector<Medium>& media, const ShadowKinds& shadows);

}  // namespace tyndall::participating_media
