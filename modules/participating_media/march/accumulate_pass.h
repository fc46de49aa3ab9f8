#pragma once
/// The march's mean over frames.

#include <memory>

#include "march/march_terms.h"
#include "media_buffer.h"
#include "media_settings.h"
#include "render/frame_graph.h"

namespace tyndall::participating_media {

/// With "temporal" on: writes `media_accumulated`, the mean of `media_marched` and what of the last frames still holds.
class AccumulatePass final : public Pass {
 public:
    /// `settings` must outlive the pass.
    AccumulatePass(std::shared_ptr<MediaBuffer> media, std::shared_ptr<MarchTerms> terms, const MediaSettings& settings)
        : media_(std::move(media)), terms_(std::move(terms)), settings_(settings) {}
    [[nodiscard]] std::string_view name() const override { return "participating_media.accumulate"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    std::shared_ptr<MediaBuffer> media_;
    std::shared_ptr<MarchTerms> terms_;
    const MediaSettings& settings_;
};

}  // namespace tyndall::participating_media
