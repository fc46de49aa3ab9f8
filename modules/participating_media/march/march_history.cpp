#include "march/march_history.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "render/light_buffer.h"

namespace tyndall::participating_media {
namespace {

/// Things this far away move by a marched pixel when the camera moves fast.
constexpr float kNearMetres = 4.0f;
/// And it turns fast when the picture moves by so many marched pixels.
constexpr float kMostPixels = 4.0f;

/// All of the lights but where their shadow maps lie: a sun's cascades follow the camera.
std::string bytes_of(const Frame& frame) {
    std::string bytes;
    for (const GpuLight& light : frame.lights.lights()) {
        const auto* first = reinterpret_cast<const char*>(&light);
        bytes.append(first, reinterpret_cast<const char*>(&light.views));
    }
    return bytes;
}

bool moves(const Surface& surface) {
    return surface.casts_shadow && surface.transform != surface.previous_transform;
}

}  // namespace

void MarchHistory::update(const Frame& frame, const MediaBuffer& media, int pixel_step) {
    std::string lights = bytes_of(frame);
    const bool holds = lights == lights_ && media.bytes() == media_ && !frame.scene.camera_cut &&
                       std::ranges::none_of(frame.scene.surfaces, moves);
    frames_ = holds ? frames_ + 1 : 0;
    const glm::vec3 eye(frame.block.eye_near);
    const float pixel = 2.0f * frame.block.tan_half_fov_exposure.y / frame.block.size_time.y;
    const float marched = pixel * static_cast<float>(pixel_step);
    const glm::mat3 view(frame.block.view);
    const float turned = std::max(glm::distance(view[0], view_[0]), glm::distance(view[2], view_[2]));
    fast_ = glm::distance(eye, eye_) > kNearMetres * marched || turned > kMostPixels * marched;
    eye_ = eye;
    view_ = view;
    lights_ = std::move(lights);
    media_ = media.bytes();
}

}  // namespace tyndall::participating_media
