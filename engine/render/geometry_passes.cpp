#include "render/geometry_passes.h"

#include "render/draw_state.h"
#include "render/frame.h"
#include "render/gpu_scene.h"
#include "render/specular_table.h"

namespace tyndall {
namespace {

const glm::vec4 kZero{0.0f};

/// Depth and what lights need to know: the same in both paths.
void declare_lit_points(PassDeclaration& declaration) {
    declaration.stage(Stage::geometry)
        .writes("scene_depth", {.format = gpu::Format::depth32f, .clear = kZero}, "reversed-Z depth, 0 = nothing")
        .writes("gbuffer_normal", {.format = gpu::Format::rgba16, .clear = kZero},
                "octahedral normal, roughness, shading model and occlusion")
        .writes("gbuffer_surface", {.format = gpu::Format::rgba16, .clear = kZero},
                "which surface of the scene is seen, its curvature, octahedral normal without the normal map");
}

DrawView camera_view(const Frame& frame) {
    return {frame.block.view_projection, glm::vec3(frame.block.eye_near)};
}

}  // namespace

void GBufferPass::declare(PassDeclaration& declaration) {
    declare_lit_points(declaration);
    declaration.writes("gbuffer_base", {.format = gpu::Format::rgba16, .clear = kZero}, "base colour, metallic")
        .writes("gbuffer_f0", {.format = gpu::Format::rgba16, .clear = kZero},
                "dielectric reflectance at normal and at grazing incidence")
        .writes("gbuffer_emissive", {.format = gpu::Format::rgba32f, .clear = kZero}, "emitted radiance, cd/m2");
}

void GBufferPass::execute(PassContext& context) {
    static const SurfaceShader kShader{"gbuffer", "render/shaders/gbuffer.frag", {}};
    context.bind_targets();
    const DrawState state(DepthState::write);
    context.frame().gpu_scene.draw(camera_view(context.frame()), kShader, {});
}

void ThinGBufferPass::declare(PassDeclaration& declaration) {
    declare_lit_points(declaration);
}

void ThinGBufferPass::execute(PassContext& context) {
    static const SurfaceShader kShader{"thin_gbuffer", "render/shaders/gbuffer.frag", {"THIN"}};
    context.bind_targets();
    const DrawState state(DepthState::write);
    context.frame().gpu_scene.draw(camera_view(context.frame()), kShader, {});
}

void MaterialPass::declare(PassDeclaration& declaration) {
    declaration.stage(Stage::compose)
        .reads("scene_depth", "surfaces seen")
        .reads("light_diffuse", "irradiance")
        .reads("light_specular_a", "specular light, by F0")
        .reads("light_specular_b", "specular light, by F90")
        .writes("radiance", {.format = gpu::Format::rgba32f, .clear = kZero}, "scene-linear radiance, cd/m2");
}

void MaterialPass::execute(PassContext& context) {
    static const SurfaceShader kShader{"materials", "render/shaders/material_pass.frag", {}};
    static constexpr std::string_view kTargets[] = {"radiance", "scene_depth"};
    context.bind_targets(kTargets, -1);
    const DrawState state(DepthState::equal);
    Frame& frame = context.frame();
    frame.gpu_scene.draw(camera_view(frame), kShader, [&](const gpu::Program& program) {
        bind_frame(program, frame);
        for (const char* buffer : {"light_diffuse", "light_specular_a", "light_specular_b"})
            program.texture(buffer, context.texture(buffer), {.filter = gpu::Filter::nearest});
        table_.bind(program);
    });
}

}  // namespace tyndall
