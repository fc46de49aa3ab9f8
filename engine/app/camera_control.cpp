#include "app/camera_control.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace tyndall {

void CameraControl::set(const glm::mat4& transform, Walker& walker) {
    eye_ = glm::vec3(transform[3]);
    const glm::vec3 forward = -glm::normalize(glm::vec3(transform[2]));
    yaw_ = std::atan2(-forward.x, -forward.z);
    pitch_ = std::asin(std::clamp(forward.y, -1.0f, 1.0f));
    if (mode_ == CameraMode::walk) walker.place(eye_);
}

void CameraControl::set_mode(CameraMode mode, Walker& walker) {
    mode_ = mode;
    if (mode_ == CameraMode::walk) walker.place(eye_);
}

void CameraControl::update(const CameraWish& wish, float seconds, Walker& walker) {
    constexpr float kSteepest = 1.55f;  // just short of straight up, where yaw loses its meaning
    yaw_ = std::remainder(yaw_ - wish.look_rad.x, 6.2831853f);
    pitch_ = std::clamp(pitch_ + wish.look_rad.y, -kSteepest, kSteepest);

    const glm::mat3 turn = glm::mat3(glm::rotate(glm::mat4(1.0f), yaw_, {0.0f, 1.0f, 0.0f}));
    if (mode_ == CameraMode::walk && walker.has_colliders()) {
        glm::vec3 velocity = turn * glm::vec3(wish.move.x, 0.0f, -wish.move.z);
        if (const float length = glm::length(velocity); length > 1.0f) velocity /= length;
        if (wish.jump) walker.jump();
        eye_ = walker.walk(velocity * walk_m_per_s * wish.speed, seconds);
        return;
    }
    const glm::mat3 tilt = turn * glm::mat3(glm::rotate(glm::mat4(1.0f), pitch_, {1.0f, 0.0f, 0.0f}));
    const glm::vec3 step = tilt * glm::vec3(wish.move.x, 0.0f, -wish.move.z) + glm::vec3(0.0f, wish.move.y, 0.0f);
    eye_ = walker.fly(eye_, step * fly_m_per_s * wish.speed * seconds);
}

glm::mat4 CameraControl::transform() const {
    const glm::mat4 turned = glm::rotate(glm::translate(glm::mat4(1.0f), eye_), yaw_, {0.0f, 1.0f, 0.0f});
    return glm::rotate(turned, pitch_, {1.0f, 0.0f, 0.0f});
}

}  // namespace tyndall
