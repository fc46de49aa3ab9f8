#include <fmt/format.h>

#include "color/implementation.h"

namespace tyndall {
namespace {

void apply(const OCIO::CPUProcessor& processor, float* values, size_t count, int channels) {
    if (count == 0) return;
    OCIO::PackedImageDesc picture(values, static_cast<long>(count), 1, channels);
    processor.apply(picture);
}

void require_triples(std::span<const float> rgb) {
    if (rgb.size() % 3 != 0) throw Error(fmt::format("{} values are not RGB triples", rgb.size()));
}

bool is_linear(OCIO::Interpolation interpolation) {
    return interpolation != OCIO::INTERP_NEAREST;
}

std::vector<DisplayShader::Lut> luts_of(const OCIO::GpuShaderDesc& shader) {
    std::vector<DisplayShader::Lut> luts;
    const char* texture = nullptr;
    const char* sampler = nullptr;
    const float* values = nullptr;
    auto interpolation = OCIO::INTERP_LINEAR;
    for (unsigned i = 0; i < shader.getNumTextures(); ++i) {
        unsigned width = 0, height = 0;
        auto kind = OCIO::GpuShaderDesc::TEXTURE_RGB_CHANNEL;
        shader.getTexture(i, texture, sampler, width, height, kind, interpolation);
        shader.getTextureValues(i, values);
        const int channels = kind == OCIO::GpuShaderDesc::TEXTURE_RED_CHANNEL ? 1 : 3;
        const size_t count = size_t{width} * height * static_cast<size_t>(channels);
        luts.push_back({sampler,
                        height > 1 ? 2 : 1,
                        static_cast<int>(width),
                        static_cast<int>(height),
                        channels,
                        is_linear(interpolation),
                        {values, values + count}});
    }
    for (unsigned i = 0; i < shader.getNum3DTextures(); ++i) {
        unsigned side = 0;
        shader.get3DTexture(i, texture, sampler, side, interpolation);
        shader.get3DTextureValues(i, values);
        luts.push_back({sampler,
                        3,
                        static_cast<int>(side),
                        static_cast<int>(side),
                        3,
                        is_linear(interpolation),
                        {values, values + size_t{side} * side * side * 3}});
    }
    return luts;
}

std::vector<DisplayShader::Uniform> uniforms_of(const OCIO::GpuShaderDesc& shader) {
    using Kind = DisplayShader::Uniform::Kind;
    std::vector<DisplayShader::Uniform> uniforms;
    for (unsigned i = 0; i < shader.getNumUniforms(); ++i) {
        OCIO::GpuShaderDesc::UniformData data;
        DisplayShader::Uniform uniform;
        uniform.name = shader.getUniform(i, data);
        switch (data.m_type) {
            case OCIO::UNIFORM_DOUBLE:
                uniform.floats = {static_cast<float>(data.m_getDouble())};
                break;
            case OCIO::UNIFORM_BOOL:
                uniform.kind = Kind::bool1;
                uniform.ints = {data.m_getBool() ? 1 : 0};
                break;
            case OCIO::UNIFORM_FLOAT3: {
                uniform.kind = Kind::float3;
                const OCIO::Float3& value = data.m_getFloat3();
                uniform.floats.assign(value.begin(), value.end());
                break;
            }
            case OCIO::UNIFORM_VECTOR_FLOAT: {
                uniform.kind = Kind::float_array;
                const float* values = data.m_vectorFloat.m_getVector();
                uniform.floats.assign(values, values + data.m_vectorFloat.m_getSize());
                break;
            }
            case OCIO::UNIFORM_VECTOR_INT: {
                uniform.kind = Kind::ivec2_array;
                const int* values = data.m_vectorInt.m_getVector();
                uniform.ints.assign(values, values + 2 * data.m_vectorInt.m_getSize());
                break;
            }
            case OCIO::UNIFORM_UNKNOWN:
                throw Error("a uniform of unknown type: " + uniform.name);
        }
        uniforms.push_back(std::move(uniform));
    }
    return uniforms;
}

}  // namespace

OCIO::ConstProcessorRcPtr ColorConfig::Implementation::display_processor(const Target& target) const {
    return config->getProcessor(OCIO::ROLE_SCENE_LINEAR, target.display.c_str(), target.view.c_str(),
                                OCIO::TRANSFORM_DIR_FORWARD);
}

OCIO::ConstCPUProcessorRcPtr ColorConfig::Implementation::processor(const std::string& from,
                                                                    const std::string& to) const {
    return guarded("from '" + from + "' to '" + to + "'",
                   [&] { return config->getProcessor(from.c_str(), to.c_str())->getDefaultCPUProcessor(); });
}

Image ColorConfig::to_working(const Image& image, std::string_view space) const {
    if (is_data(space)) return to_float(image);
    const auto processor = self_->processor(self_->space(space), OCIO::ROLE_SCENE_LINEAR);
    const bool has_alpha = image.channels == 2 || image.channels >= 4;
    Image out = to_float(with_channels(image, has_alpha ? 4 : 3));
    const std::span<float> values = out.floats();
    self_->guarded("converting a picture", [&] {
        apply(*processor, values.data(), values.size() / static_cast<size_t>(out.channels), out.channels);
    });
    return out;
}

void ColorConfig::convert(std::span<float> rgb, std::string_view from, std::string_view to) const {
    require_triples(rgb);
    if (is_data(from) || is_data(to)) return;
    const auto processor = self_->processor(self_->space(from), self_->space(to));
    self_->guarded("converting colours", [&] { apply(*processor, rgb.data(), rgb.size() / 3, 3); });
}

void ColorConfig::apply_display(std::span<float> rgb, std::string_view display, std::string_view view) const {
    require_triples(rgb);
    const Implementation::Target target = self_->target(display, view);
    self_->guarded("view '" + target.view + "' of display '" + target.display + "'", [&] {
        apply(*self_->display_processor(target)->getDefaultCPUProcessor(), rgb.data(), rgb.size() / 3, 3);
    });
}

DisplayShader ColorConfig::display_shader(std::string_view display, std::string_view view) const {
    const Implementation::Target target = self_->target(display, view);
    return self_->guarded("view '" + target.view + "' of display '" + target.display + "'", [&] {
        OCIO::GpuShaderDescRcPtr shader = OCIO::GpuShaderDesc::CreateShaderDesc();
        shader->setLanguage(OCIO::GPU_LANGUAGE_GLSL_4_0);
        shader->setFunctionName("ocio_display");
        shader->setResourcePrefix("ocio_");
        self_->display_processor(target)->getDefaultGPUProcessor()->extractGpuShaderInfo(shader);
        return DisplayShader{shader->getShaderText(), luts_of(*shader), uniforms_of(*shader)};
    });
}

}  // namespace tyndall
