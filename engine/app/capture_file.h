#pragma once
/// A capture: pictures of a scene at a fixed clock, one thing changed at a time, and what must hold of them.

#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "ecs/description.h"

namespace tyndall {

/// The scene with a few values changed; gives one picture per camera.
struct CaptureVariant {
    std::string name = "plain";
    std::vector<std::string> set;  ///< "/json/pointer=value", as `--set`
    std::string camera;            ///< empty = the capture's
    std::string target;            ///< a frame-graph target instead of "radiance"
    int32_t frames = 0;            ///< 0 = the capture's
};
void describe(StructBuilder<CaptureVariant>& d);

/// One thing that must hold of a variant's scene-linear picture. Limits that are negative are not asked for.
struct Expectation {
    std::string of = "plain";  ///< the variant that is judged
    std::string equals;        ///< another variant it is held against ...
    std::string reference;     ///< ... or a scene-linear image file: beside the capture, or "references:NAME"
    bool display = false;      ///< compares the display pictures' values, 0..1, in place of the radiance
    float scale = 1.0f;        ///< the other picture is multiplied by this first
    int32_t box_filter = 1;    ///< the judged picture is shrunk by this factor first
    float max_relmse = -1.0f;
    float max_mean_error = -1.0f;              ///< |mean ratio - 1|
    float max_flip = -1.0f;                    ///< mean LDR-FLIP of the display pictures
    float max_difference = -1.0f;              ///< largest absolute difference; 0 = the same bits
    glm::vec4 region{0.0f, 0.0f, 1.0f, 1.0f};  ///< left, top, width, height as fractions of the picture
    glm::vec2 mean_between{-1.0f};             ///< the region's mean luminance, cd/m2
    std::string reason;                        ///< why this limit
};
void describe(StructBuilder<Expectation>& d);

/// The content of a capture file.
struct CaptureFile {
    int32_t tyndall_capture = 1;  ///< version of the format
    std::string doc;
    std::string scene;
    std::vector<std::string> cameras;  ///< empty = the scene's own
    glm::vec2 size{640.0f, 360.0f};
    int32_t frames = 1;
    float step_s = 1.0f / 60.0f;
    std::vector<CaptureVariant> variants;
    std::vector<Expectation> expect;
    std::filesystem::path file;  ///< where it was read from
};
void describe(StructBuilder<CaptureFile>& d);

/// Whether a JSON text is a capture (and not a scene).
[[nodiscard]] bool is_capture(const std::string& text);
/// Reads and checks a capture file. Throws Error with every problem.
[[nodiscard]] CaptureFile load_capture(const std::filesystem::path& file);

}  // namespace tyndall
