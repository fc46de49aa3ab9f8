#include "froxels/froxel_history.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "render/light_buffer.h"

namespace tyndall::participating_media {
namespace {

constexpr float kLeastWeight = 0.03f;         ///< of a frame in the mean over frames
constexpr float kLeastWeightChanging = 0.5f;  ///< the same while media change
constexpr glm::vec4 kEverywhere(0.0f, 0.0f, 0.0f, -1.0f);
constexpr glm::vec4 kNowhere(1e30f, 0.0f, 0.0f, 0.0f);

glm::vec4 reach_of(const GpuLight& light) {
    const bool bounded = light.position_range.w > 0.0f && light.direction_kind.w < 2.0f;
    return bounded ? light.position_range : kEverywhere;
}

bool same(const Term& a, const Term& b) {
    return a.source == b.source && a.light == b.light && a.medium == b.medium;
}

}  // namespace

void FroxelHistory::add_dirty(const glm::vec4& sphere) {
    if (dirty_.size() < kMostDirty)
        dirty_.push_back(sphere);
    else
        dirty_.back() = kEverywhere;
}

void FroxelHistory::compare_lights(const Frame& frame, const std::vector<Term>& terms) {
    std::vector<LightState> now(frame.scene.lights.size());
    for (const Term& term : terms) {
        if (term.source != Term::Source::light) continue;
        const GpuLight& light = frame.lights.lights()[term.light];
        now[term.light] = {{light.position_range, light.direction_kind, light.right_cos_outer, light.up_cos_inner,
                            light.intensity_profile, light.gobo}};
    }
    if (now.size() != lights_.size() || !std::ranges::equal(terms, terms_, same)) {
        add_dirty(kEverywhere);
    } else {
        for (size_t i = 0; i < now.size(); ++i) {
            if (now[i] == lights_[i]) continue;
            const bool bounded = lights_[i].values[0].w > 0.0f && lights_[i].values[1].w < 2.0f;
            add_dirty(reach_of(frame.lights.lights()[i]));
            add_dirty(bounded ? lights_[i].values[0] : kEverywhere);
        }
    }
    lights_ = std::move(now);
    terms_ = terms;
}

/// Where something that casts shadows moves, all that its lights reach is new.
void FroxelHistory::compare_casters(const Frame& frame) {
    for (const Surface& surface : frame.scene.surfaces) {
        if (!surface.casts_shadow || surface.transform == surface.previous_transform) continue;
        const glm::vec3 centre = 0.5f * (surface.bounds.low + surface.bounds.high);
        const float radius = 0.5f * glm::distance(surface.bounds.low, surface.bounds.high);
        for (const GpuLight& light : frame.lights.lights()) {
            const glm::vec4 reach = reach_of(light);
            const bool meets = reach.w < 0.0f || glm::distance(glm::vec3(reach), centre) < reach.w + radius;
            if (light.shadow.x > 0.0f && meets) add_dirty(reach);
        }
    }
}

void FroxelHistory::update(const Frame& frame, const MediaBuffer& media, const std::vector<Term>& terms,
                           const FroxelGrid& grid, bool usable) {
    previous_view_projection_ = view_projection_;
    previous_eye_ = eye_;
    previous_depths_ = depths_;
    view_projection_ = frame.block.view_projection;
    eye_ = glm::vec3(frame.block.eye_near);
    depths_ = grid.depths();
    has_ = usable && known_ && !frame.scene.camera_cut;
    known_ = true;
    frames_ = has_ ? frames_ + 1 : 0;
    dirty_.clear();
    compare_lights(frame, terms);
    compare_casters(frame);
    if (dirty_.empty()) dirty_.push_back(kNowhere);
    least_weight_ = media.bytes() == media_ ? kLeastWeight : kLeastWeightChanging;
    media_ = media.bytes();
}

int FroxelHistory::kind() const {
    if (!has_) return 0;
    return view_projection_ == previous_view_projection_ && depths_ == previous_depths_ ? 2 : 1;
}

void FroxelHistory::bind(const gpu::Program& program) const {
    program.set("history_view_projection", previous_view_projection_);
    program.set("history_eye", previous_eye_);
    program.set("history_depths", previous_depths_);
    program.set("least_weight", least_weight_);
    program.set("dirty_count", static_cast<int>(dirty_.size()));
    for (size_t i = 0; i < dirty_.size(); ++i) program.set(fmt::format("dirty[{}]", i), dirty_[i]);
}

}  // namespace tyndall::participating_media
