// What the maps know, in the picture.

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <cmath>
#include <glm/matrix.hpp>

#include "radiance_maps/dispatch.h"
#include "radiance_maps/radiance_maps_pass.h"
#include "render/pixel_rectangle.h"
#include "render/seams.h"
#include "seen_surface.h"

namespace tyndall::translucency {

const gpu::Program& use_compute(PassContext& context, std::string_view shader, std::vector<std::string> defines) {
    const gpu::Program& program =
        context.frame().shaders.program({.name = fmt::format("translucency.radiance_maps.{}", shader),
                                         .compute = fmt::format("translucency/radiance_maps/{}.comp", shader),
                                         .defines = std::move(defines)});
    program.use();
    bind_frame(program, context.frame());
    return program;
}

void wait_for_shaders() {
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT |
                    GL_COMMAND_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
}

void RadianceMapsPass::forget_around(PassContext& context) {
    constexpr float kUnknown[4] = {};
    const std::string_view targets[] = {kAround};
    context.bind_targets(targets, -1);
    glClearBufferfv(GL_COLOR, 0, kUnknown);
}

/// Draws the object into the target with the light from all around.
void RadianceMapsPass::light_around(PassContext& context, const Seen& seen) {
    static const gpu::ProgramDesc kDesc{.name = "translucency.radiance_maps.around",
                                        .vertex = "translucency/radiance_maps/around.vert",
                                        .fragment = "translucency/radiance_maps/around.frag"};
    const std::string_view targets[] = {kAround};
    context.bind_targets(targets, -1);
    Frame& frame = context.frame();
    const gpu::Program& program = frame.shaders.program(kDesc);
    program.use();
    bind_frame(program, frame);
    frame.seams.bind(Seam::indirect_light, program, context);
    for (const char* target : {"scene_depth", "gbuffer_normal"})
        program.texture(target, context.texture(target), {.filter = gpu::Filter::nearest});
    program.set("world_from_body", seen.world_from_body);
    program.set("clip_from_world", frame.block.view_projection);
    const glm::mat3 turn(seen.world_from_body);
    program.set("normals_to_world", turn / std::cbrt(std::abs(glm::determinant(turn))));
    glEnable(GL_CULL_FACE);
    glFrontFace(glm::determinant(glm::mat3(seen.world_from_body)) < 0.0f ? GL_CW : GL_CCW);
    seen.body.mesh().draw(seen.object.balanced);
    glDisable(GL_CULL_FACE);
    glFrontFace(GL_CCW);
}

void RadianceMapsPass::combine(PassContext& context, const Seen& seen) {
    Frame& frame = context.frame();
    const PixelRectangle pixels = pixels_of(seen.surface.bounds, frame.block.view_projection, context.size());
    const bool around = has_indirect_light(frame);
    const gpu::Program& program =
        use_compute(context, "combine", around ? std::vector<std::string>{"AROUND"} : std::vector<std::string>{});
    seen.object.interior.bind(program);
    program.block("State", seen.object.state);
    program.block("Views", seen.body.block());
    for (const char* target : {"scene_depth", "gbuffer_normal", "gbuffer_surface"})
        program.texture(target, context.texture(target), {.filter = gpu::Filter::nearest});
    if (around) program.texture("around", context.texture(kAround), {.filter = gpu::Filter::nearest});
    program.texture("places", seen.body.places(), {.filter = gpu::Filter::nearest});
    program.texture("leaving", seen.object.leaving, {.filter = gpu::Filter::nearest});
    program.image("light_diffuse", context.texture("light_diffuse"), 0, true);
    program.set("view_count", seen.body.views());
    program.set("resolution", seen.body.resolution());
    program.set("samples", settings_.radiance_maps.samples);
    program.set("frames", settings_.radiance_maps.frames);
    program.set("layer_count", int(seen.object.lights.layers().size()));
    program.set("body_from_world", glm::inverse(seen.world_from_body));
    program.set("number", seen.number);
    program.set("low", pixels.low);
    glDispatchCompute(GLuint(groups_of(pixels.size.x)), GLuint(groups_of(pixels.size.y)), 1);
    wait_for_shaders();
}

}  // namespace tyndall::translucency
