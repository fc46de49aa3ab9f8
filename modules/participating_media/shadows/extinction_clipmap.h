#pragma once
/// The extinction of uneven media in nested boxes of voxels: shadows toward any light, from anywhere.

#include <glm/vec3.hpp>
#include <vector>

#include "geometry/bounds.h"
#include "media_buffer.h"
#include "media_settings.h"

namespace tyndall::participating_media {

inline constexpr int kMostClipmapLevels = 6;

/// The boxes of all levels, finest first. The last is that of all uneven media; each before it is half as wide along
/// each axis and lies as near to the camera as it can without leaving the last. They move in steps of an eighth of
/// their width, so voxels keep their places in the world.
[[nodiscard]] std::vector<Bounds> clipmap_boxes(const Bounds& media, const glm::vec3& camera, int levels, int voxels);

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
