#pragma once
/// The frame's media on the GPU, shared by the march and the two seam providers.

#include <glm/mat4x4.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/gpu.h"
#include "scene/render_scene.h"

namespace tyndall::participating_media {

/// So many media are rendered at once; further ones are left out, with a warning.
inline constexpr size_t kMaximumMedia = 16;

/// The uniform block "Media" of shaders/media.glsl. Makes its GL objects when first used.
class MediaBuffer {
 public:
    /// Uploads the scene's media when they changed. Returns those that are rendered; what the shaders cannot render is
    /// left out, with a warning.
    const std::vector<Medium>& update(const RenderScene& scene, bool enabled);
    [[nodiscard]] const std::vector<Medium>& media() const { return media_; }
    /// Sets the block and the count on a program that includes media.glsl.
    void bind(const gpu::Program& program) const;

 private:
    void warn_once(std::string_view what);

    gpu::Buffer buffer_;
    std::vector<Medium> media_;
    std::string uploaded_;  ///< the buffer's bytes
    std::set<std::string> warned_;
};

}  // namespace tyndall::participating_media
