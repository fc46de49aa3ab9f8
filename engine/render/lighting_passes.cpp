#include "render/lighting_passes.h"

#include <epoxy/gl.h>

#include <array>

#include "render/draw_state.h"
#include "render/frame.h"
#include "render/gpu_scene.h"
#include "render/light_volumes.h"

namespace tyndall {
namespace {

constexpr std::array<const char*, 3> kLightBuffers{"light_diffuse", "light_specular_a", "light_specular_b"};
constexpr std::array<const char*, 3> kLightBufferDocs{"irradiance, lux", "specular light to be multiplied by F0",
                                                      "specular light to be multiplied by F90"};

void bind_gbuffer(const gpu::Program& program, const PassContext& context) {
    for (const char* name : {"scene_depth", "gbuffer_normal"})
        program.texture(name, context.texture(name), {.filter = gpu::Filter::nearest});
}

}  // namespace

void IndirectPass::declare(PassDeclaration& declaration) {
    declaration.stage(Stage::lighting)
        .reads("scene_depth", "where surfaces are")
        .reads("gbuffer_normal", "normal, roughness, occlusion");
    for (size_t i = 0; i < kLightBuffers.size(); ++i)
        declaration.writes(kLightBuffers[i], {.format = gpu::Format::rgba32f}, kLightBufferDocs[i]);
    seams_.declare(Seam::indirect_light, declaration);
}

void IndirectPass::execute(PassContext& context) {
    static const gpu::ProgramDesc kDesc{.name = "indirect", .fragment = "render/shaders/indirect.frag"};
    context.bind_targets();
    const gpu::Program& program = context.frame().shaders.program(kDesc);
    program.use();
    bind_frame(program, context.frame());
    bind_gbuffer(program, context);
    table_.bind(program);
    seams_.bind(Seam::indirect_light, program, context);
    gpu::draw_fullscreen();
}

LightsPass::~LightsPass() {
    if (vertex_array_ != 0) glDeleteVertexArrays(1, &vertex_array_);
}

void LightsPass::declare(PassDeclaration& declaration) {
    declaration.stage(Stage::lighting)
        .reads("scene_depth", "where surfaces are")
        .reads("gbuffer_normal", "normal, roughness, shading model");
    for (size_t i = 0; i < kLightBuffers.size(); ++i) declaration.updates(kLightBuffers[i], kLightBufferDocs[i]);
    seams_.declare(Seam::shading_model, declaration);
    seams_.declare(Seam::light_transmittance, declaration);
}

void LightsPass::create_volumes() {
    std::vector<glm::vec3> vertices = sphere_volume();
    sphere_vertices_ = int(vertices.size());
    const std::vector<glm::vec3> cone = cone_volume();
    cone_vertices_ = int(cone.size());
    vertices.insert(vertices.end(), cone.begin(), cone.end());
    vertices_ = gpu::Buffer(std::span<const glm::vec3>(vertices), "light_volumes");
    glCreateVertexArrays(1, &vertex_array_);
    glEnableVertexArrayAttrib(vertex_array_, 0);
    glVertexArrayAttribFormat(vertex_array_, 0, 3, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(vertex_array_, 0, 0);
    glVertexArrayVertexBuffer(vertex_array_, 0, vertices_.name(), 0, sizeof(glm::vec3));
}

LightsPass::Programs::Programs(const std::vector<std::string>& defines)
    : volume({.name = "lights",
              .vertex = "render/shaders/light_volume.vert",
              .fragment = "render/shaders/light.frag",
              .defines = defines}),
      screen({.name = "lights", .fragment = "render/shaders/light.frag", .defines = defines}) {}

void LightsPass::execute(PassContext& context) {
    static constexpr std::string_view kTargets[] = {"light_diffuse", "light_specular_a", "light_specular_b",
                                                    "scene_depth"};
    if (vertex_array_ == 0) create_volumes();
    context.bind_targets(kTargets, -1);
    const DrawState state(DepthState::in_front, BlendState::add);
    const ShadingModelUse models = seams_.shading_models(context);
    glEnable(GL_SCISSOR_TEST);
    add_lights(context, {kStandardModelOnly}, outside(models.pixels, context.size()));
    if (!models.pixels.empty()) add_lights(context, models.defines, {&models.pixels, 1});
    glDisable(GL_SCISSOR_TEST);
}

void LightsPass::add_lights(PassContext& context, const std::vector<std::string>& defines,
                            std::span<const PixelRectangle> where) {
    Frame& frame = context.frame();
    const Bounds surfaces = frame.gpu_scene.bounds();
    Programs& chosen = programs_.try_emplace(defines, defines).first->second;
    for (const bool whole_screen : {false, true}) {
        LightPrograms& programs = whole_screen ? chosen.screen : chosen.volume;
        programs.begin();
        for (size_t i = 0; i < frame.scene.lights.size(); ++i) {
            const LightVolume volume = light_volume(frame.scene.lights[i], surfaces);
            if ((volume.kind == LightVolumeKind::everywhere) != whole_screen) continue;
            const gpu::Program& program = programs.use(frame, i, [&](const gpu::Program& fresh) {
                bind_gbuffer(fresh, context);
                seams_.bind(Seam::shading_model, fresh, context);
                seams_.bind(Seam::light_transmittance, fresh, context);
            });
            program.set("light_index", unsigned(i));
            for (const PixelRectangle& pixels : where) {
                glScissor(pixels.low.x, pixels.low.y, pixels.size.x, pixels.size.y);
                draw(program, frame.block.view_projection, volume);
            }
        }
    }
}

void LightsPass::draw(const gpu::Program& program, const glm::mat4& clip_from_world, const LightVolume& volume) {
    if (volume.kind == LightVolumeKind::everywhere) return gpu::draw_fullscreen();
    program.set("clip_from_volume", clip_from_world * volume.world_from_volume);
    const bool sphere = volume.kind == LightVolumeKind::sphere;
    glBindVertexArray(vertex_array_);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    glDrawArrays(GL_TRIANGLES, sphere ? 0 : sphere_vertices_, sphere ? sphere_vertices_ : cone_vertices_);
    glCullFace(GL_BACK);
    glDisable(GL_CULL_FACE);
}

}  // namespace tyndall
