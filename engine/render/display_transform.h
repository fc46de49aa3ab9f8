#pragma once
/// OpenColorIO's display transform in shaders.

#include <string>
#include <vector>

#include "color/color.h"
#include "gpu/gpu.h"
#include "gpu/shader_library.h"

namespace tyndall {

/// Serves the text "render/display_transform.glsl", which defines `vec4 ocio_display(vec4 working)`, and binds what it
/// needs.
class DisplayTransform {
 public:
    DisplayTransform(const ColorConfig& config, gpu::ShaderLibrary& shaders);
    ~DisplayTransform();
    DisplayTransform(const DisplayTransform&) = delete;
    DisplayTransform& operator=(const DisplayTransform&) = delete;

    /// Empty names are the configuration's defaults. Throws Error with the nearest name, and keeps the last good one.
    void set(const std::string& display, const std::string& view);
    /// The configuration changed. Names that it no longer has are replaced by its defaults, with a warning.
    void reload();
    /// Sets uniforms and tables of a program in use that includes the text.
    void bind(const gpu::Program& program);

 private:
    void upload_tables();
    void release_tables();

    const ColorConfig& config_;
    gpu::ShaderLibrary& shaders_;
    std::string display_;
    std::string view_;
    DisplayShader shader_;
    std::vector<unsigned int> tables_;  // GL textures of shader_.luts, made by the first bind
};

}  // namespace tyndall
