#include "render/display_passes.h"

#include "render/frame.h"
#include "scene/settings.h"

namespace tyndall {
namespace {

constexpr gpu::SamplerDesc kNearest{.filter = gpu::Filter::nearest};

const gpu::Program& use(const gpu::ProgramDesc& desc, PassContext& context) {
    const gpu::Program& program = context.frame().shaders.program(desc);
    program.use();
    bind_frame(program, context.frame());
    return program;
}

/// Half the width of the noise: one step of 8 bits, or none.
float dither_amplitude(const Settings& settings) {
    return settings.get<ImageSettings>().dither ? 1.0f / 255.0f : 0.0f;
}

/// How view.frag is to understand a target.
std::string_view meaning_of(const std::string& name, gpu::Format format) {
    if (gpu::is_depth(format)) return "SHOW_DEPTH";
    if (name == "gbuffer_normal") return "SHOW_NORMAL";
    switch (format) {
        case gpu::Format::rgba16f:
        case gpu::Format::rgba32f:
        case gpu::Format::r11g11b10f:
            return "SHOW_RADIANCE";
        case gpu::Format::r8:
        case gpu::Format::r16:
        case gpu::Format::r16f:
        case gpu::Format::r32f:
            return "SHOW_GREY";
        default:
            return "SHOW_VALUES";
    }
}

}  // namespace

void DisplayPass::declare(PassDeclaration& declaration) {
    declaration.stage(Stage::display).reads("radiance", "the finished picture");
    if (antialiased_) {
        declaration.writes("encoded", {.format = gpu::Format::rgba16}, "display-encoded picture, luma in alpha");
    } else {
        declaration.writes("display", {.format = gpu::Format::rgba8}, "what the display is sent");
    }
}

void DisplayPass::execute(PassContext& context) {
    static const gpu::ProgramDesc kDesc{.name = "display", .fragment = "render/shaders/display.frag"};
    context.bind_targets();
    const gpu::Program& program = use(kDesc, context);
    program.texture("radiance", context.texture("radiance"), kNearest);
    program.set("dither_amplitude", antialiased_ ? 0.0f : dither_amplitude(context.frame().settings));
    transform_.bind(program);
    gpu::draw_fullscreen();
}

void AntialiasPass::declare(PassDeclaration& declaration) {
    declaration.stage(Stage::display)
        .reads("encoded", "display-encoded picture, luma in alpha")
        .writes("display", {.format = gpu::Format::rgba8}, "what the display is sent");
}

void AntialiasPass::execute(PassContext& context) {
    static const gpu::ProgramDesc kDesc{.name = "antialias", .fragment = "render/shaders/antialias.frag"};
    context.bind_targets();
    const gpu::Program& program = use(kDesc, context);
    program.texture("encoded", context.texture("encoded"), {.filter = gpu::Filter::linear});
    program.set("dither_amplitude", dither_amplitude(context.frame().settings));
    gpu::draw_fullscreen();
}

void ViewPass::declare(PassDeclaration& declaration) {
    declaration.stage(Stage::display)
        .reads(target_, "to be shown")
        .writes("display", {.format = gpu::Format::rgba8}, "what the display is sent");
}

void ViewPass::execute(PassContext& context) {
    context.bind_targets();
    const gpu::Texture& target = context.texture(target_);
    const gpu::TextureDesc& desc = target.desc();
    gpu::ProgramDesc program_desc{.name = "view", .fragment = "render/shaders/view.frag"};
    program_desc.defines.emplace_back(meaning_of(target_, desc.format));
    if (desc.shape == gpu::Shape::array) program_desc.defines.emplace_back("SHOW_ARRAY");
    if (desc.shape == gpu::Shape::volume) program_desc.defines.emplace_back("SHOW_VOLUME");
    const gpu::Program& program = use(program_desc, context);
    program.texture("target", target, kNearest);
    program.set("layers", desc.shape == gpu::Shape::flat ? 1 : desc.layers);
    transform_.bind(program);
    gpu::draw_fullscreen();
}

}  // namespace tyndall
