#include "app/overlay.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

namespace tyndall {
namespace {

constexpr ImGuiWindowFlags kPlain = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                                    ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                                    ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;
const ImVec4 kRed{1.0f, 0.45f, 0.4f, 1.0f};
constexpr float kMargin = 10.0f;

/// A see-through box whose corner lies at a fraction of the window.
void box(const char* name, ImVec2 corner) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const ImVec2 at{kMargin + corner.x * (size.x - 2.0f * kMargin), kMargin + corner.y * (size.y - 2.0f * kMargin)};
    ImGui::SetNextWindowPos(at, ImGuiCond_Always, corner);
    ImGui::SetNextWindowBgAlpha(0.55f);
    ImGui::SetNextWindowSizeConstraints({0.0f, 0.0f}, {size.x - 2.0f * kMargin, size.y - 2.0f * kMargin});
    ImGui::Begin(name, nullptr, kPlain);
}

void draw_statistics(const OverlayText& text) {
    box("statistics", {1.0f, 0.0f});
    ImGui::Text("%.1f ms a frame, %zu triangles, %d shadow layers drawn", text.frame_ms, text.statistics.triangles,
                text.statistics.shadow_layers);
    ImGui::Text("targets %.1f MB", static_cast<double>(text.statistics.target_bytes) / 1e6);
    for (const PassTime& pass : text.statistics.passes)
        ImGui::Text("%7.2f ms  %s", pass.milliseconds, pass.name.c_str());
    ImGui::End();
}

}  // namespace

Overlay::Overlay(platform::Window& window) {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    ImFontConfig font;
    font.SizePixels = 13.0f * window.content_scale();
    io.Fonts->AddFontDefault(&font);
    ImGui::GetStyle().ScaleAllSizes(window.content_scale());
    ImGui_ImplGlfw_InitForOpenGL(window.native(), false);  // the window's own callbacks stay
    ImGui_ImplOpenGL3_Init("#version 450 core");
}

Overlay::~Overlay() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void Overlay::draw(const OverlayText& text) {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    if (!text.problems.empty()) {
        box("problems", {0.0f, 0.0f});
        ImGui::PushTextWrapPos(ImGui::GetIO().DisplaySize.x * 0.7f);
        ImGui::PushStyleColor(ImGuiCol_Text, kRed);
        ImGui::TextUnformatted(text.problems.c_str());
        ImGui::PopStyleColor();
        ImGui::PopTextWrapPos();
        ImGui::End();
    }
    if (!text.status.empty()) {
        box("status", {0.0f, 1.0f});
        ImGui::TextUnformatted(text.status.c_str());
        ImGui::End();
    }
    if (!text.help.empty()) {
        box("help", {0.5f, 0.5f});
        ImGui::TextUnformatted(text.help.c_str());
        ImGui::End();
    }
    if (text.show_statistics) draw_statistics(text);
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace tyndall
