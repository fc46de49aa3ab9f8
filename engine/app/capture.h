#pragma once
/// Taking pictures at a fixed clock, and writing them with everything that made them.

#include <filesystem>
#include <string>
#include <vector>

#include "app/engine.h"
#include "app/expectations.h"
#include "platform/context.h"

namespace tyndall {

/// A texture's texels, top row first, three channels, f32.
[[nodiscard]] Image read_back(const gpu::Texture& texture);

/// How one picture is taken.
struct Shot {
    std::string camera;  ///< empty = the scene's choice
    glm::ivec2 size{1280, 720};
    int frames = 1;  ///< the last one is the picture
    double step_s = 1.0 / 60.0;
    int supersample = 1;  ///< rendered this many times larger in each direction, box-filtered down
    std::string target;   ///< a frame-graph target shown in place of the picture
};

/// Renders the shot from a fresh clock and reads it back. Throws Error for an unknown camera or target,
/// and for a scene without a camera.
[[nodiscard]] CapturedPicture take(Engine& engine, const Shot& shot);

/// Which files `write` makes.
struct PictureFiles {
    bool png = true;
    bool exr = true;
};
/// Writes STEM.png (display), STEM.exr (scene-linear) and STEM.json: scene, changes, every setting, versions, GL
/// strings.
void write(Engine& engine, const platform::GlInfo& gl, const Shot& shot, const Assignments& changes,
           const CapturedPicture& picture, const std::filesystem::path& stem, const PictureFiles& files);

}  // namespace tyndall
