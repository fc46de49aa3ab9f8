#pragma once
/// What the steps of the technique radiance_maps share.

#include <string>
#include <string_view>
#include <vector>

#include "render/frame.h"
#include "render/frame_graph.h"

namespace tyndall::translucency {

/// The target with the irradiance from all around.
inline constexpr const char* kAround = "radiance_map_around";

/// The program shaders/radiance_maps/SHADER.comp, in use and with the frame bound.
const gpu::Program& use_compute(PassContext& context, std::string_view shader, std::vector<std::string> defines = {});
/// Until what shaders wrote can be read, whatever it is.
void wait_for_shaders();
/// Groups of 8 that hold so many.
[[nodiscard]] constexpr int groups_of(int texels) {
    return (texels + 7) / 8;
}

}  // namespace tyndall::translucency
