#include "app/player.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <thread>

#include "app/capture.h"
#include "core/clock.h"
#include "core/log.h"
#include "core/paths.h"
#include "image/image_io.h"
#include "scene/components.h"

namespace tyndall {
namespace {

/// Between frames: the compiler has the processors then, so that a change is seen sooner.
constexpr std::chrono::milliseconds kRestWhileBuilding{150};

platform::WindowDesc window_desc(const PlayerOptions& options) {
    return {.title = "Tyndall - " + options.scene.stem().string(),
            .size = options.size,
            .fullscreen = options.fullscreen,
            .vsync = options.vsync};
}

}  // namespace

Player::Player(const PlayerOptions& options)
    : options_(options),
      window_(window_desc(options)),
      bindings_(platform::Bindings::load(paths::root() / "config" / "input.json")),
      engine_(true, options.ocio),
      overlay_(window_) {
    engine_.set_streaming(true);
    engine_.load_scene(options_.scene, options_.changes);
    if (!options_.camera.empty()) engine_.select_camera(options_.camera);
    engine_.renderer().show(options_.view);
    if (options_.watch) builder_.emplace(paths::build(), paths::root() / "modules");
    control_.walk_m_per_s = bindings_.speeds.walk_m_per_s;
    control_.fly_m_per_s = bindings_.speeds.fly_m_per_s;
    collect_colliders();
    control_.set(engine_.scene().camera.transform, walker_);
    log::info("{} shows the keys", bindings_.describe("toggle_help"));
}

Player::~Player() = default;

void Player::run() {
    FrameClock clock = options_.frames > 0 ? FrameClock::fixed(1.0 / 60.0) : FrameClock::real();
    for (int count = 0; !window_.close_requested() && (options_.frames == 0 || count < options_.frames); ++count)
        frame(clock.tick().step_s);
    if (!options_.screenshot.empty()) save_screenshot(options_.screenshot);
}

void Player::frame(double seconds) {
    window_.poll();
    handle_actions();
    watch();
    if (builder_ && builder_->building()) std::this_thread::sleep_for(kRestWhileBuilding);
    const glm::ivec2 pixels = window_.framebuffer_size();
    if (pixels.x <= 0 || pixels.y <= 0) return;
    move_camera(static_cast<float>(seconds));
    const glm::ivec2 size = glm::max(glm::ivec2(glm::vec2(pixels) * options_.render_scale), glm::ivec2(1));
    engine_.frame(paused_ ? 0.0 : seconds, size, View{control_.transform(), -exposure_steps_});
    if (screenshot_due_) save_screenshot(fmt::format("tyndall-{}.png", std::time(nullptr)));
    screenshot_due_ = false;
    if (const gpu::Texture* display = engine_.renderer().target("display")) window_.blit(display->name(), size);
    overlay_.draw(overlay_text(seconds));
    window_.swap();
}

void Player::handle_actions() {
    if (pressed("quit")) window_.request_close();
    if (pressed("fullscreen")) window_.set_fullscreen(!window_.fullscreen());
    if (pressed("capture_mouse")) window_.capture_mouse(!window_.mouse_captured());
    if (pressed("toggle_camera_mode"))
        control_.set_mode(control_.mode() == CameraMode::walk ? CameraMode::fly : CameraMode::walk, walker_);
    if (pressed("next_camera") && !viewpoints_.empty()) look_through((viewpoint_ + 1) % viewpoints_.size());
    if (pressed("previous_camera") && !viewpoints_.empty())
        look_through((viewpoint_ + viewpoints_.size() - 1) % viewpoints_.size());
    if (pressed("next_view")) next_target();
    if (pressed("exposure_up")) exposure_steps_ += 0.5f;
    if (pressed("exposure_down")) exposure_steps_ -= 0.5f;
    if (pressed("pause")) paused_ = !paused_;
    if (pressed("toggle_help")) show_help_ = !show_help_;
    if (pressed("toggle_statistics")) engine_.renderer().set_timing(show_statistics_ = !show_statistics_);
    if (pressed("screenshot")) screenshot_due_ = true;
    if (pressed("switch_path")) {
        const std::vector<std::string> names = Renderer::paths();
        const auto at = std::find(names.begin(), names.end(), engine_.options().path);
        engine_.options().path = at == names.end() || at + 1 == names.end() ? names.front() : *(at + 1);
        engine_.apply_options();
    }
    if (pressed("reload")) {
        try {
            engine_.reload_scene();
            colliders_version_ = 0;
        } catch (const Error& error) {
            log::error("{}", error.what());
        }
    }
}

void Player::next_target() {
    const std::vector<std::string> views = engine_.renderer().views();
    target_ = (target_ + 1) % (views.size() + 1);
    engine_.renderer().show(target_ == 0 ? std::string() : views[target_ - 1]);
}

void Player::look_through(size_t viewpoint) {
    viewpoint_ = viewpoint;
    path_time_s_.reset();
    const Entity entity = engine_.world().find_named(viewpoints_[viewpoint]);
    if (engine_.world().find<CameraPathComponent>(entity)) {
        path_time_s_ = 0.0;
    } else if (engine_.world().find<CameraComponent>(entity)) {
        engine_.select_camera(viewpoints_[viewpoint]);
        control_.set(engine_.extract().camera.transform, walker_);
    }
    engine_.cut();
}

CameraWish Player::wish(float seconds) const {
    const platform::InputState& input = window_.input();
    const auto axis = [&](const char* positive, const char* negative) {
        return bindings_.value(input, positive) - bindings_.value(input, negative);
    };
    CameraWish wish;
    wish.move = {axis("move_right", "move_left"), axis("move_up", "move_down"), axis("move_forward", "move_back")};
    const float stick = glm::radians(bindings_.look.stick_deg_per_s) * seconds;
    wish.look_rad = {axis("look_right", "look_left") * stick, axis("look_up", "look_down") * stick};
    if (window_.mouse_captured() || bindings_.down(input, "look_hold")) {
        const glm::vec2 turn = input.motion() * glm::radians(bindings_.look.mouse_deg_per_pixel);
        wish.look_rad += glm::vec2(turn.x, -turn.y);
    }
    if (bindings_.look.invert_y) wish.look_rad.y = -wish.look_rad.y;
    wish.speed = bindings_.down(input, "fast") ? bindings_.speeds.fast_factor : 1.0f;
    wish.jump = bindings_.pressed(input, "jump");
    return wish;
}

void Player::move_camera(float seconds) {
    collect_colliders();
    const CameraWish wanted = wish(seconds);
    if (path_time_s_) {
        const auto* path =
            engine_.world().find<CameraPathComponent>(engine_.world().find_named(viewpoints_[viewpoint_]));
        const bool taken_over = wanted.move != glm::vec3(0.0f) || wanted.look_rad != glm::vec2(0.0f);
        if (!path || taken_over || (!path->loop && *path_time_s_ > static_cast<double>(path->duration_s))) {
            path_time_s_.reset();
        } else {
            control_.set_mode(CameraMode::fly, walker_);
            control_.set(camera_path_transform(*path, static_cast<float>(*path_time_s_)), walker_);
            *path_time_s_ += paused_ ? 0.0 : static_cast<double>(seconds);
            return;
        }
    }
    control_.update(wanted, seconds, walker_);
}

void Player::collect_colliders() {
    if (colliders_version_ == engine_.world().version()) return;
    walker_.clear_colliders();
    viewpoints_ = engine_.cameras();
    engine_.world().each<const CameraPathComponent>(
        [&](Entity entity, const CameraPathComponent&) { viewpoints_.push_back(engine_.world().name(entity)); });
    for (const Surface& surface : engine_.extract().surfaces) {
        if (!surface.collides) continue;
        std::vector<glm::vec3> positions;
        for (const glm::vec3& position : surface.mesh->mesh.positions)
            positions.push_back(glm::vec3(surface.transform * glm::vec4(position, 1.0f)));
        walker_.add_collider(positions, surface.mesh->mesh.indices);
    }
    colliders_version_ = engine_.world().version();  // extraction itself may have changed it
}

void Player::watch() {
    if (!options_.watch) return;
    builder_->update();
    engine_.reload_changed();
}

OverlayText Player::overlay_text(double seconds) const {
    OverlayText text;
    text.problems = engine_.problems() + (builder_ ? builder_->problems() : "");
    if (builder_ && builder_->building()) text.status = "building...";
    if (target_ > 0) text.status = engine_.renderer().shown();
    if (show_help_) text.help = help();
    text.show_statistics = show_statistics_;
    text.frame_ms = seconds * 1000.0;
    if (show_statistics_) text.statistics = engine_.renderer().statistics();
    return text;
}

std::string Player::help() const {
    std::string text;
    for (const platform::ActionInfo& action : platform::engine_actions())
        if (const std::string keys = bindings_.describe(action.name); !keys.empty())
            text += fmt::format("{:28} {}\n", keys, action.doc);
    return text;
}

void Player::save_screenshot(const std::filesystem::path& file) const {
    const gpu::Texture* display = engine_.renderer().target("display");
    if (!display) return;
    try {
        save_png(file, to_u8(read_back(*display)));
        log::info("wrote {}", file.string());
    } catch (const Error& error) {
        log::error("{}", error.what());
    }
}

}  // namespace tyndall
