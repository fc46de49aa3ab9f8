#include "platform/input.h"

namespace tyndall::platform {
namespace {

constexpr float kDown = 0.5f;

bool known(Control control) {
    return static_cast<int>(control) >= 0 && static_cast<int>(control) < kControls;
}

size_t index(Control control) {
    return static_cast<size_t>(control);
}

}  // namespace

void InputState::begin_frame() {
    pressed_.reset();
    released_.reset();
    motion_ = {};
    scroll_ = {};
}

void InputState::set(Control control, float value) {
    if (!known(control)) return;
    const bool before = down(control);
    values_[index(control)] = value;
    if (down(control) && !before) pressed_.set(index(control));
    if (!down(control) && before) released_.set(index(control));
}

float InputState::value(Control control) const {
    return known(control) ? values_[index(control)] : 0.0f;
}

bool InputState::down(Control control) const {
    return value(control) > kDown;
}

bool InputState::pressed(Control control) const {
    return known(control) && pressed_.test(index(control));
}

bool InputState::released(Control control) const {
    return known(control) && released_.test(index(control));
}

}  // namespace tyndall::platform
