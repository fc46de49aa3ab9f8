#pragma once
/// Draws of what is marched: a term each, within the rectangle that its light reaches.

#include <array>
#include <memory>
#include <string>

#include "march/march_history.h"
#include "march/shadow_mips.h"
#include "media_buffer.h"
#include "media_programs.h"
#include "media_settings.h"
#include "render/frame_graph.h"

namespace tyndall::participating_media {

/// Full-resolution pixels from one marched pixel to the next.
[[nodiscard]] int pixel_step(Resolution resolution);

class MarchTerms {
 public:
    /// `settings` must outlive this.
    MarchTerms(std::shared_ptr<MediaBuffer> media, const MediaSettings& settings);

    /// Marches all terms into the bound target: adds rgb radiance (cd/m2) and in a its guide
    /// (shaders/march/guide.glsl).
    void march(PassContext& context);
    /// Adds to each pixel of the bound frame the guide times the target "media_shares".
    void add_shares(PassContext& context);
    /// One term alone is marched: spread() does for it what shaders/march/shares.comp and add_shares() do for several.
    [[nodiscard]] bool alone() const;
    /// Creates "media_in_scatter" from what was `marched` at a lower resolution, and the list of unknown pixels.
    void spread(PassContext& context, const gpu::Texture& marched, const gpu::Buffer& list);
    /// Marches the pixels of the list that shares.comp made, and adds them to "media_in_scatter".
    void march_listed(PassContext& context, const gpu::Buffer& list);
    /// What of the last frames holds; only with "temporal".
    [[nodiscard]] const MarchHistory& history() const { return history_; }
    /// Whether rays leave the box around all media before they end: what ray.glsl calls MEDIA_END.
    static bool media_end(const Bounds& media);
    /// Sets what shaders/march/ray.glsl declares.
    static void bind_ray(const gpu::Program& program, PassContext& context, const Bounds& media, int pixel_step);
    /// Sets what shaders/march/shares.glsl declares, but for `media_in_scatter`.
    void bind_shares(const gpu::Program& program, PassContext& context, const gpu::Texture& marched,
                     const gpu::Buffer& list) const;
    /// Starts a program that has its spread_shares() over a frame of this size.
    static void dispatch_shares(glm::ivec2 size, int pixel_step);

 private:
    /// main.glsl's.
    enum class Way { marched, guide_only, spread, listed };
    static gpu::ProgramDesc describe(Way way, const std::string& what);
    void draw(PassContext& context, Way way);
    void draw_or_dispatch(glm::ivec2 size) const;
    [[nodiscard]] int step() const;
    [[nodiscard]] int steps() const;
    void draw_light(PassContext& context, size_t light, int medium);
    /// What lights a medium evenly: its own emission, or light from all around.
    void draw_glow(PassContext& context, Term::Source source, int medium);
    void bind(const gpu::Program& program, PassContext& context) const;

    std::shared_ptr<MediaBuffer> media_;
    const MediaSettings& settings_;
    gpu::Texture blue_noise_;
    std::array<MediaPrograms, 4> programs_;  ///< by Way
    Way way_ = Way::marched;                 ///< of the draws that are being made
    const gpu::Buffer* list_ = nullptr;
    const gpu::Texture* marched_ = nullptr;  ///< what is spread
    MarchHistory history_;
    ShadowMips shadow_mips_;
    bool skips_dark_ = false;
};

}  // namespace tyndall::participating_media
