#include "seen_surface.h"

#include <epoxy/gl.h>

#include <cmath>

#include "render/frame.h"
#include "render/light_state.h"
#include "render/seams.h"

namespace tyndall::translucency {

std::vector<SeenSurface> seen_surfaces(TechniquePlan& plan, Technique technique, PassContext& context) {
    const RenderScene& scene = context.frame().scene;
    std::vector<SeenSurface> seen;
    for (const size_t index : plan.surfaces(scene, technique)) {
        const Surface& surface = scene.surfaces[index];
        const PixelRectangle pixels = pixels_of(surface.bounds, context.frame().block.view_projection, context.size());
        const float volume = glm::determinant(glm::mat3(surface.transform));
        if (pixels.empty() || volume == 0.0f || !std::isfinite(volume)) continue;
        seen.push_back({&surface, float(index + 1), pixels});
    }
    return seen;
}

bool has_indirect_light(const Frame& frame) {
    return has_light_all_around(frame.scene) || frame.seams.providers(Seam::indirect_light).size() > 1;
}

void declare_pixels(PassDeclaration& declaration) {
    declaration.stage(Stage::diffusion)
        .reads("scene_depth", "where the surfaces are seen")
        .reads("gbuffer_normal", "toward the eye")
        .reads("gbuffer_surface", "which surface is seen")
        .updates("light_diffuse", "light that leaves translucent surfaces in place of what arrives there");
}

void bind_lit_pixels(const gpu::Program& program, PassContext& context, const PixelRectangle& pixels) {
    for (const char* target : {"scene_depth", "gbuffer_normal"})
        program.texture(target, context.texture(target), {.filter = gpu::Filter::nearest});
    program.image("light_diffuse", context.texture("light_diffuse"), 0, true);
    program.set("pixels_low", pixels.low);
    program.set("pixels_size", pixels.size);
}

void bind_pixels(const gpu::Program& program, PassContext& context, const SeenSurface& seen,
                 const InteriorBuffers& interior) {
    interior.bind(program);
    bind_numbered_pixels(program, context, seen);
}

void bind_numbered_pixels(const gpu::Program& program, PassContext& context, const SeenSurface& seen) {
    bind_lit_pixels(program, context, seen.pixels);
    program.texture("gbuffer_surface", context.texture("gbuffer_surface"), {.filter = gpu::Filter::nearest});
    program.set("number", seen.number);
}

void bind_seen(const gpu::Program& program, PassContext& context, const Surface& surface, float number,
               SpecularTableTexture& table) {
    table.bind(program);
    for (const char* target : {"scene_depth", "gbuffer_normal", "gbuffer_surface"})
        program.texture(target, context.texture(target), {.filter = gpu::Filter::nearest});
    const Material& boundary = *surface.material;
    program.set("boundary_base", glm::vec4(glm::vec3(boundary.base_colour), boundary.ior));
    program.set("boundary_mirror", glm::vec4(boundary.specular_colour, boundary.specular));
    program.set("number", number);
}

void dispatch_pixels(glm::ivec2 size) {
    constexpr int kGroup = 8;
    glDispatchCompute(GLuint((size.x + kGroup - 1) / kGroup), GLuint((size.y + kGroup - 1) / kGroup), 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
}

void dispatch_columns(glm::ivec2 size) {
    constexpr int kColumn = 8;
    dispatch_pixels({size.x, (size.y + kColumn - 1) / kColumn});
}

void begin_pixels(PassContext& context, const SeenSurface& seen, const InteriorBuffers& interior, bool elsewhere) {
    static const gpu::ProgramDesc kDesc{.name = "translucency.begin", .compute = "translucency/begin.comp"};
    Frame& frame = context.frame();
    const gpu::Program& program = frame.shaders.program(kDesc);
    program.use();
    bind_frame(program, frame);
    frame.seams.bind(Seam::indirect_light, program, context);
    bind_pixels(program, context, seen, interior);
    program.set("elsewhere", elsewhere ? 1.0f : 0.0f);
    dispatch_pixels(seen.pixels.size);
}

}  // namespace tyndall::translucency
