#pragma once
/// Tells shaders which kinds of media a frame has, so that they are compiled for no others.

#include <string>
#include <vector>

#include "scene/render_scene.h"

namespace tyndall::participating_media {

/// What some light of the frame does beside its own light: how shadows of uneven media are found, and whether fog
/// lights surfaces.
struct LightKinds {
    bool marched = false, opacity = false, fourier = false, clipmap = false;
    bool surface_glow = false;
};

/// The text that stands for shaders/media_kinds.glsl (ShaderLibrary::set_text).
[[nodiscard]] std::string media_kinds(const std::vector<Medium>& media, const LightKinds& lights);

}  // namespace tyndall::participating_media
