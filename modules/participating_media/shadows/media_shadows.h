#pragma once
/// Shadows of uneven media: what the light-transmittance seam looks up in place of marching toward the light.

#include <memory>
#include <vector>

#include "media_buffer.h"
#include "media_kinds.h"
#include "media_settings.h"
#include "render/frame_graph.h"
#include "shadows/extinction_clipmap.h"
#include "shadows/shadow_fit.h"

namespace tyndall::participating_media {

/// How each light's shadow is found, and the textures for it. Maps and levels are made again when the media, the light
/// or the settings changed; the camera matters to the clipmap's finer levels alone. Costs nothing while all media are
/// even. Makes its GL objects when first used.
class MediaShadows {
 public:
    /// Makes ready what the frame's lights need. The media must be up to date.
    void update(Frame& frame, const MediaBuffer& media, const MediaSettings& settings);
    /// Sets all that shaders/shadows/read.glsl declares.
    void bind(const gpu::Program& program, const MediaSettings& settings);
    /// Null before the first map was made.
    [[nodiscard]] const gpu::Texture* maps() const { return maps_.name() != 0 ? &maps_ : nullptr; }
    /// Maps and levels that the last update made.
    [[nodiscard]] int made() const { return made_; }

 private:
    struct Block;
    /// What a map was made of.
    struct Map {
        ShadowFit fit;
        uint64_t media_version = 0;
        MediaShadowSettings settings;
        bool operator==(const Map&) const = default;
    };
    void update_version(const MediaBuffer& media);
    void plan(Block& block, const RenderScene& scene, const UnevenMedia& uneven, const MediaSettings& settings);
    void make_maps(gpu::ShaderLibrary& shaders, const MediaBuffer& media);
    void make_map(const gpu::Program& program, size_t map) const;
    void make_textures();
    void upload(const Block& block);

    std::vector<Map> wanted_, made_maps_;  ///< one a light that has a map, in the texture's order
    uint64_t media_version_ = 0;
    std::string media_key_, uploaded_;
    LightKinds kinds_;  ///< of this frame's lights
    int layers_ = 0;    ///< of a map
    int made_ = 0;
    gpu::Texture maps_, nothing_;
    gpu::Buffer buffer_;
    ExtinctionClipmap clipmap_;
};

/// Makes the frame's shadows of media ready before anything is lit; its target "media_shadows" is what the
/// light-transmittance seam needs.
class MediaShadowsPass final : public Pass {
 public:
    /// `settings` must outlive the pass.
    MediaShadowsPass(std::shared_ptr<MediaBuffer> media, std::shared_ptr<MediaShadows> shadows,
                     const MediaSettings& settings)
        : media_(std::move(media)), shadows_(std::move(shadows)), settings_(settings) {}
    [[nodiscard]] std::string_view name() const override { return "participating_media.shadows"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    std::shared_ptr<MediaBuffer> media_;
    std::shared_ptr<MediaShadows> shadows_;
    const MediaSettings& settings_;
};

}  // namespace tyndall::participating_media
