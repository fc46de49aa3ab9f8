#pragma once
/// The extinction of uneven media in nested boxes of voxels: shadows toward any light, from anywhere.

#include <glm/vec3.hpp>
#include <vector>

#include "geometry/bounds.h"
#include "gpu/gpu.h"
#include "gpu/shader_library.h"
#include "media_buffer.h"
#include "media_settings.h"
#include "shadows/shadow_fit.h"

namespace tyndall::participating_media {

/// One texture, levels stacked along z. Levels are filled as a whole, when their box or the media changed. Makes its
/// GL objects when first used.
class ExtinctionClipmap {
 public:
    /// Fills what changed; `media_version` is another number whenever the media are others.
    void update(gpu::ShaderLibrary& shaders, const MediaBuffer& media, const Bounds& bounds, const glm::vec3& camera,
                const MediaShadowSettings& settings, uint64_t media_version);
    /// Sets all that shaders/shadows/clipmap.glsl declares.
    void bind(const gpu::Program& program, const MediaShadowSettings& settings) const;
    /// Gives the texture back.
    void forget();
    /// Levels filled by the last update.
    [[nodiscard]] int filled() const { return filled_; }

 private:
    struct Level {
        Bounds box;
        uint64_t media_version = 0;
        int samples = 0;
    };
    void fill(gpu::ShaderLibrary& shaders, const MediaBuffer& media, size_t level, int samples) const;
    std::vector<Level> levels_;
    int voxels_ = 0, filled_ = 0;
    gpu::Texture texture_;
};

}  // namespace tyndall::participating_media
