#include "gpu/format.h"

#include <epoxy/gl.h>

#include <array>

namespace tyndall::gpu {

const FormatInfo& info(Format format) {
    // In the order of the enumeration.
    static constexpr std::array<FormatInfo, 17> kTable{{
        {"r8", 1, GL_R8, GL_RED, GL_UNSIGNED_BYTE},
        {"rg8", 2, GL_RG8, GL_RG, GL_UNSIGNED_BYTE},
        {"rgba8", 4, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE},
        {"srgb8_alpha8", 4, GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE},
        {"r16", 2, GL_R16, GL_RED, GL_UNSIGNED_SHORT},
        {"rg16", 4, GL_RG16, GL_RG, GL_UNSIGNED_SHORT},
        {"rgba16", 8, GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT},
        {"r16f", 2, GL_R16F, GL_RED, GL_HALF_FLOAT},
        {"rg16f", 4, GL_RG16F, GL_RG, GL_HALF_FLOAT},
        {"rgba16f", 8, GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT},
        {"r32f", 4, GL_R32F, GL_RED, GL_FLOAT},
        {"rg32f", 8, GL_RG32F, GL_RG, GL_FLOAT},
        {"rgba32f", 16, GL_RGBA32F, GL_RGBA, GL_FLOAT},
        {"r11g11b10f", 4, GL_R11F_G11F_B10F, GL_RGB, GL_UNSIGNED_INT_10F_11F_11F_REV},
        {"r32ui", 4, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT},
        {"rgb10_a2", 4, GL_RGB10_A2, GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV},
        {"depth32f", 4, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT},
    }};
    return kTable[static_cast<size_t>(format)];
}

size_t bytes_per_texel(Format format) {
    return info(format).bytes;
}

std::string_view name_of(Format format) {
    return info(format).name;
}

bool is_depth(Format format) {
    return format == Format::depth32f;
}

}  // namespace tyndall::gpu
