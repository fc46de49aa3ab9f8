#include "points/detail.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace tyndall::translucency {
namespace {

constexpr int kFewestLevels = 8;

}  // namespace

float points_worth(const Surface& surface, float area, const FrameBlock& frame, float pixels) {
    const glm::vec3 eye(frame.eye_near);
    const glm::vec3 nearest = glm::clamp(eye, surface.bounds.low, surface.bounds.high);
    const float distance = std::max(glm::distance(eye, nearest), frame.eye_near.w);
    const float pixel = 2.0f * frame.tan_half_fov_exposure.y / frame.size_time.y;
    const float apart = pixels * pixel * distance;
    return area / (apart * apart);
}

int levels_for(float points, int before, int most) {
    // at least 1: what is worth nothing, or not a number, has the fewest
    const float known = points >= 1.0f ? points : 1.0f;
    const float wanted = std::clamp(std::log2(known), float(std::min(kFewestLevels, most)), float(most));
    const bool stays = before > 0 && before <= most && wanted < float(before) + 0.5f && wanted > float(before) - 1.5f;
    return stays ? before : int(std::ceil(wanted));
}

}  // namespace tyndall::translucency
