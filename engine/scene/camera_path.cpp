#include <algorithm>
#include <array>
#include <cmath>

#include "scene/component_form.h"
#include "scene/components.h"

namespace tyndall {
namespace {

constexpr int kSteps = 64;  // of a span when its length is measured
constexpr float kLookShare = 0.05f;

/// One point of the barycentric form of a Catmull-Rom span (Barry and Goldman 1988); knots k0..k3, k1 <= k <= k2.
glm::vec3 catmull_rom(const std::array<glm::vec3, 4>& p, const std::array<float, 4>& knot, float k) {
    const auto mix = [&](const glm::vec3& a, const glm::vec3& b, size_t from, size_t to) {
        return glm::mix(a, b, (k - knot[from]) / (knot[to] - knot[from]));
    };
    const glm::vec3 a1 = mix(p[0], p[1], 0, 1);
    const glm::vec3 a2 = mix(p[1], p[2], 1, 2);
    const glm::vec3 a3 = mix(p[2], p[3], 2, 3);
    return mix(mix(a1, a2, 0, 2), mix(a2, a3, 1, 3), 1, 2);
}

class Spline {
 public:
    explicit Spline(const CameraPathComponent& path)
        : points_(path.points), loop_(path.loop && path.points.size() > 2) {
        lengths_.push_back(0.0f);
        for (size_t span = 0; span < spans(); ++span) {
            CameraPathPoint before = at(span, 0.0f);
            for (int step = 1; step <= kSteps; ++step) {
                const CameraPathPoint here = at(span, static_cast<float>(step) / kSteps);
                lengths_.push_back(lengths_.back() + glm::distance(before.position, here.position) +
                                   kLookShare * glm::distance(before.look_at, here.look_at));
                before = here;
            }
        }
    }

    /// The point after a share (0..1) of the whole length.
    [[nodiscard]] CameraPathPoint at_share(float share) const {
        const float length = share * lengths_.back();
        const auto above = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, length);
        const auto index = static_cast<size_t>(above - lengths_.begin()) - 1;
        const float step = lengths_[index + 1] - lengths_[index];
        const float within = step > 0.0f ? (length - lengths_[index]) / step : 0.0f;
        const size_t span = index / kSteps;
        return at(span, (static_cast<float>(index % kSteps) + within) / kSteps);
    }

 private:
    [[nodiscard]] size_t spans() const { return loop_ ? points_.size() : points_.size() - 1; }

    /// Point `index` of the path; beyond an open end, the end mirrored.
    [[nodiscard]] CameraPathPoint control(ptrdiff_t index) const {
        const auto count = static_cast<ptrdiff_t>(points_.size());
        const auto point = [&](ptrdiff_t i) { return points_[static_cast<size_t>(i)]; };
        if (loop_) return point((index + count) % count);
        if (index >= 0 && index < count) return point(index);
        const ptrdiff_t end = index < 0 ? 0 : count - 1;
        const CameraPathPoint a = point(end);
        const CameraPathPoint b = point(index < 0 ? 1 : count - 2);
        return {2.0f * a.position - b.position, 2.0f * a.look_at - b.look_at};
    }

    [[nodiscard]] CameraPathPoint at(size_t span, float u) const {
        std::array<glm::vec3, 4> positions;
        std::array<glm::vec3, 4> targets;
        for (size_t i = 0; i < 4; ++i) {
            const CameraPathPoint point = control(static_cast<ptrdiff_t>(span + i) - 1);
            positions[i] = point.position;
            targets[i] = point.look_at;
        }
        std::array<float, 4> knots{};
        for (size_t i = 1; i < 4; ++i)
            knots[i] = knots[i - 1] + std::max(1e-3f, std::sqrt(glm::distance(positions[i - 1], positions[i])));
        const float k = glm::mix(knots[1], knots[2], u);
        return {catmull_rom(positions, knots, k), catmull_rom(targets, knots, k)};
    }

    const std::vector<CameraPathPoint>& points_;
    bool loop_;
    std::vector<float> lengths_;  ///< from the start to each step of each span
};

}  // namespace

glm::mat4 camera_path_transform(const CameraPathComponent& path, float time_s) {
    if (path.points.empty()) return glm::mat4(1.0f);
    const float turns = path.duration_s > 0.0f ? time_s / path.duration_s : 0.0f;
    const float share = path.loop ? turns - std::floor(turns) : std::clamp(turns, 0.0f, 1.0f);
    const CameraPathPoint point = path.points.size() == 1 ? path.points.front() : Spline(path).at_share(share);
    glm::mat4 transform = glm::mat4_cast(look_at_rotation(glm::mat4(1.0f), point.position, point.look_at));
    transform[3] = glm::vec4(point.position, 1.0f);
    return transform;
}

}  // namespace tyndall
