#include "scatter_maps/scatter_map.h"

#include <epoxy/gl.h>

#include <array>
#include <cmath>

#include "render/draw_state.h"
#include "render/frame.h"
#include "render/seams.h"

namespace tyndall::translucency {
namespace {

constexpr float kNowhere = -1e30f;

}  // namespace

size_t ScatterMap::bytes(int size) {
    const size_t texels = size_t(size) * size_t(size);
    return texels * (16 + 4) + texels * 48 * 4 / 3;
}

void ScatterMap::make_textures(int size) {
    if (light_.name() != 0 && light_.desc().width == size) return;
    const auto made = [size](gpu::Format format, int mips) {
        return gpu::Texture({.format = format, .width = size, .height = size, .mips = mips},
                            "translucency.scatter_map");
    };
    exits_ = made(gpu::Format::rgba32f, 1);
    light_ = made(gpu::Format::rgba32f, 0);
    way_ = made(gpu::Format::rgba32f, 0);
    flux_ = made(gpu::Format::rgba32f, 0);
    depth_ = made(gpu::Format::depth32f, 1);
    using Attachment = gpu::Framebuffer::Attachment;
    exit_target_ = gpu::Framebuffer(std::array{Attachment{&exits_}}, {}, "translucency.exits");
    entry_target_ = gpu::Framebuffer(std::array{Attachment{&light_}, Attachment{&way_}, Attachment{&flux_}}, {&depth_},
                                     "translucency.entries");
}

void ScatterMap::update(PassContext& context, size_t light, const Surface& surface, int size, std::string state,
                        const std::function<void(const gpu::Program&)>& bind, LightPrograms& programs) {
    if (state == made_from_) return;
    made_from_ = std::move(state);
    make_textures(size);
    view_ = light_view(context.frame().scene.lights[light], surface.mesh->mesh, surface.transform, size);
    view_block_.update(view_, size);
    draw_exits(context, surface);
    draw_entries(context, light, surface, bind, programs);
    for (gpu::Texture* texture : {&light_, &way_, &flux_}) texture->generate_mips();
}

/// The nearest and the farthest of the faces that look away from the light, and the farthest that looks at it.
void ScatterMap::draw_exits(PassContext& context, const Surface& surface) const {
    static const gpu::ProgramDesc kDesc{.name = "translucency.scatter_maps.exit",
                                        .vertex = "translucency/light_view.vert",
                                        .fragment = "translucency/scatter_maps/exit.frag"};
    exit_target_.bind();
    exit_target_.clear_colour(0, glm::vec4(kNowhere));
    const gpu::Program& program = context.frame().shaders.program(kDesc);
    program.use();
    view_block_.bind(program);
    glEnable(GL_BLEND);
    glBlendEquation(GL_MAX);
    const bool mirrored = glm::determinant(glm::mat3(surface.transform)) < 0.0f;
    glFrontFace(mirrored ? GL_CW : GL_CCW);
    draw_in(view_, program, context.frame().gpu_scene, surface);
    glFrontFace(GL_CCW);
    glBlendEquation(GL_FUNC_ADD);
    glDisable(GL_BLEND);
}

void ScatterMap::draw_entries(PassContext& context, size_t light, const Surface& surface,
                              const std::function<void(const gpu::Program&)>& bind, LightPrograms& programs) {
    entry_target_.bind();
    for (int i = 0; i < 3; ++i) entry_target_.clear_colour(i, glm::vec4(0.0f));
    entry_target_.clear_depth();
    programs.begin();
    const gpu::Program& program = programs.use(context.frame(), light, [&](const gpu::Program& fresh) {
        context.frame().seams.bind(Seam::light_transmittance, fresh, context);
        bind(fresh);
    });
    program.set("light_index", unsigned(light));
    view_block_.bind(program);
    program.texture("exits", exits_, {.filter = gpu::Filter::nearest});
    const DrawState state(DepthState::write);
    draw_in(view_, program, context.frame().gpu_scene, surface);
}

void ScatterMap::bind(const gpu::Program& program) const {
    const gpu::SamplerDesc mips{
        .filter = gpu::Filter::trilinear, .wrap_u = gpu::Wrap::border_zero, .wrap_v = gpu::Wrap::border_zero};
    view_block_.bind(program);
    program.texture("entry_light", light_, mips);
    program.texture("entry_way", way_, mips);
    program.texture("entry_flux", flux_, mips);
    program.texture("exits", exits_, {.filter = gpu::Filter::linear});
}

}  // namespace tyndall::translucency
