#pragma once
/// Text over the picture: what is broken, what is shown, what the frame costs. Dear ImGui.

#include <string>
#include <vector>

#include "platform/window.h"
#include "render/renderer.h"

namespace tyndall {

/// What the overlay says in a frame.
struct OverlayText {
    std::string problems;  ///< shown in red until it is gone
    std::string status;    ///< one line
    std::string help;      ///< keys; empty = not shown
    FrameStatistics statistics;
    bool show_statistics = false;
    double frame_ms = 0.0;
};

/// Draws into the window's framebuffer, after Window::blit and before Window::swap.
class Overlay {
 public:
    explicit Overlay(platform::Window& window);
    ~Overlay();
    Overlay(const Overlay&) = delete;
    Overlay& operator=(const Overlay&) = delete;
    void draw(const OverlayText& text);
};

}  // namespace tyndall
