#pragma once
/// A capture: pictures of a scene at a fixed clock, one thing changed at a time, and what must hold of them.

#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <string_view>
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

/// A picture of the reference path tracer, kept beside the capture file as NAME.exr: app/stored_reference.h.
struct TracedReference {
    std::string name;
    std::string variant;           ///< whose scene is traced; empty = the first
    std::vector<std::string> set;  ///< further changes, after the variant's
    std::string camera;            ///< empty = the variant's, otherwise the capture's only one
    glm::vec2 size{0.0f};          ///< 0 = the capture's; it must divide that
    int32_t samples = 1024;        ///< a pixel, at most
    float noise = 0.0f;            ///< stops before that when this noise is reached; 0 = does not
    int32_t seed = 0;
    std::vector<int32_t> orders;  ///< lowest and highest number of times that light was scattered; empty = any
    bool single_scattering = false;
    bool no_surfaces = false;  ///< surfaces are black
    bool no_media = false;     ///< media absorb and emit, but do not scatter
};
void describe(StructBuilder<TracedReference>& d);

/// One thing that must hold of a variant's scene-linear picture. Limits that are negative are not asked for.
struct Expectation {
    std::string of = "plain";  ///< the variant that is judged
    std::string equals;        ///< another variant it is held against ...
    std::string reference;     ///< ... or a scene-linear image file: beside the capture, or "references:NAME" ...
    std::string traced;        ///< ... or one of the capture's traced references
    bool baseline = false;     ///< `reference` is an earlier picture, which no truth backs
    bool display = false;      ///< compares the display pictures' values, 0..1, in place of the radiance
    float scale = 1.0f;        ///< the other picture is multiplied by this first
    int32_t box_filter = 1;    ///< the judged picture is shrunk by this factor first
    float max_relmse = -1.0f;
    float max_mean_error = -1.0f;              ///< |mean ratio - 1|
    float max_flip = -1.0f;                    ///< mean LDR-FLIP of the display pictures, or at the display exposure
    float min_z_p = -1.0f;                     ///< of the Z-test, in which the judged picture counts as exact
    float max_difference = -1.0f;              ///< largest absolute difference; 0 = the same bits
    glm::vec4 region{0.0f, 0.0f, 1.0f, 1.0f};  ///< left, top, width, height as fractions of the picture
    glm::vec2 mean_between{-1.0f};             ///< the region's mean luminance, cd/m2
    std::string reason;                        ///< why this limit
};
void describe(StructBuilder<Expectation>& d);

/// What the name of a picture in the folder of references begins with.
inline constexpr std::string_view kReferencesPrefix = "references:";

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
    std::vector<TracedReference> references;
    std::vector<Expectation> expect;
    std::filesystem::path file;  ///< where it was read from

    /// The variant or reference of that name. Throws Error for one that is not there, with the nearest.
    [[nodiscard]] const CaptureVariant& variant(const std::string& name) const;
    [[nodiscard]] const TracedReference& reference(const std::string& name) const;
    /// The variant that a reference is traced from.
    [[nodiscard]] const CaptureVariant& variant_of(const TracedReference& reference) const;
    /// The camera that a reference is seen through; empty = the scene's choice.
    [[nodiscard]] std::string camera_of(const TracedReference& reference) const;
};
void describe(StructBuilder<CaptureFile>& d);

/// Whether a JSON text is a capture (and not a scene).
[[nodiscard]] bool is_capture(const std::string& text);
/// Reads and checks a capture file. Throws Error with every problem.
[[nodiscard]] CaptureFile load_capture(const std::filesystem::path& file);

}  // namespace tyndall
