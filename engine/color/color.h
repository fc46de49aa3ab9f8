#pragma once
/// Colour management through OpenColorIO: which space a file is in, the way into the working space, and the way out to
/// a display, on the CPU and as GLSL. The working space is the configuration's role scene_linear.

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.h"

namespace tyndall {

/// A display transform as GLSL 4.0, with what it needs bound.
struct DisplayShader {
    /// A table that the text samples with linear or nearest filtering, clamped to its edge.
    struct Lut {
        std::string sampler;        ///< the sampler's name in the text
        int dimensions = 2;         ///< 1: sampler1D, 2: sampler2D, 3: sampler3D
        int width = 0;              ///< texels; a 3D table is a cube of this side
        int height = 1;             ///< texels; 1 for a 1D table
        int channels = 3;           ///< 1 (red) or 3
        bool linear = true;         ///< else nearest
        std::vector<float> values;  ///< 32-bit floats, first coordinate fastest
    };
    /// A uniform of the text, with the value that the configuration gives it.
    struct Uniform {
        enum class Kind { float1, bool1, float3, float_array, ivec2_array };
        std::string name;
        Kind kind = Kind::float1;
        std::vector<float> floats;  ///< float1, float3, float_array
        std::vector<int> ints;      ///< bool1, ivec2_array
    };
    std::string text;  ///< declares the samplers and uniforms and defines `vec4 ocio_display(vec4 working)`
    std::vector<Lut> luts;
    std::vector<Uniform> uniforms;
};

/// An OpenColorIO configuration. Const functions may be called from several threads.
class ColorConfig {
 public:
    /// Loads `file` when it is not empty, else $OCIO when set, else the project's config/color/tyndall.ocio. Throws
    /// Error naming the file when it is missing, broken, or lacks scene_linear or a display.
    explicit ColorConfig(const std::filesystem::path& file = {});
    ~ColorConfig();
    ColorConfig(ColorConfig&&) noexcept;
    ColorConfig& operator=(ColorConfig&&) noexcept;

    [[nodiscard]] const std::filesystem::path& file() const;
    /// The colour space of the role scene_linear.
    [[nodiscard]] std::string working_space() const;
    [[nodiscard]] std::vector<std::string> color_spaces() const;
    [[nodiscard]] std::vector<std::string> displays() const;
    /// Views of a display; empty = the default display. Throws Error for an unknown display.
    [[nodiscard]] std::vector<std::string> views(std::string_view display = {}) const;
    [[nodiscard]] std::string default_display() const;
    [[nodiscard]] std::string default_view(std::string_view display = {}) const;

    /// The colour space of a picture file. `wanted`, when not empty, wins: a colour space, alias or role, or "data".
    /// Otherwise the configuration's file rules decide; where only its default rule fits, EXR and HDR files are linear
    /// Rec.709 and others sRGB, if the configuration has such spaces under a usual name. Throws Error for an unknown
    /// `wanted`.
    [[nodiscard]] std::string space_of_file(const std::filesystem::path& file, std::string_view wanted = {}) const;
    /// The configuration's space of sRGB-encoded Rec.709 colours, which glTF demands of its colour textures. Throws
    /// Error when there is none under a usual name.
    [[nodiscard]] std::string srgb_texture_space() const;
    /// Whether a space holds numbers that are no colours: they are never converted. "data" always does.
    [[nodiscard]] bool is_data(std::string_view space) const;
    /// Whether the sRGB curve alone leads from `space` to the working space, as a GPU's sRGB texture formats decode.
    [[nodiscard]] bool decodes_as_srgb(std::string_view space) const;

    /// The picture as f32 in the working space; alpha stays as it is, and grey becomes three channels. Data is only
    /// made f32. Throws Error for an unknown space.
    [[nodiscard]] Image to_working(const Image& image, std::string_view space) const;
    /// Converts packed RGB triples between two spaces. Throws Error for an unknown space.
    void convert(std::span<float> rgb, std::string_view from, std::string_view to) const;

    /// From working-space RGB triples to what the display is sent; not clamped. Empty names are the defaults. Throws
    /// Error for an unknown display or view.
    void apply_display(std::span<float> rgb, std::string_view display = {}, std::string_view view = {}) const;
    /// The same transform for the GPU. Exposure is the caller's: multiply before.
    [[nodiscard]] DisplayShader display_shader(std::string_view display = {}, std::string_view view = {}) const;

 private:
    struct Implementation;
    std::unique_ptr<Implementation> self_;
};

}  // namespace tyndall
