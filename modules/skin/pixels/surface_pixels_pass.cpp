#include "pixels/surface_pixels_pass.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/matrix.hpp>

#include "render/frame.h"
#include "render/gpu_scene.h"
#include "render/pixel_rectangle.h"
#include "seen_mesh.h"
#include "texture_space/surface_finish.h"

namespace tyndall::skin {
namespace {

constexpr int kColumns = 1024;

/// Whether it is to be drawn. `colour`: for its colour too.
bool has_pixels(const Surface& surface, bool colour) {
    if (!surface.diffusion) return false;
    return (colour && scatters_colour(surface)) || thickness_use(*surface.diffusion) > 0.0f;
}

}  // namespace

void SurfacePixelsPass::declare(PassDeclaration& declaration) {
    declaration.stage(Stage::diffusion)
        .reads("scene_depth", "where the skin is")
        .reads("gbuffer_base", "whether colour is known without", true)
        .writes("skin_pixels", {.format = gpu::Format::rgba32f},
                "base colour to the power that counts where light enters, metres of the body's thickness");
}

void SurfacePixelsPass::execute(PassContext& context) {
    static constexpr std::string_view kTargets[] = {"skin_pixels", "scene_depth"};
    const RenderScene& scene = context.frame().scene;
    const bool colour = context.find_texture("gbuffer_base") == nullptr;
    const auto wanted = [&](const Surface& surface) { return has_pixels(surface, colour); };
    if (settings_.enabled && std::ranges::any_of(scene.surfaces, wanted)) {
        context.bind_targets(kTargets, -1);
        const std::array<float, 4> nothing{1.0f, 1.0f, 1.0f, -1.0f};
        glClearBufferfv(GL_COLOR, 0, nothing.data());
        for (const Surface& surface : scene.surfaces)
            if (wanted(surface) && has_volume(surface)) draw(context, surface, colour && scatters_colour(surface));
    }
    vertices_.end_frame();
}

void SurfacePixelsPass::draw(PassContext& context, const Surface& surface, bool coloured) {
    Frame& frame = context.frame();
    if (pixels_of(surface.bounds, frame.block.view_projection, context.size()).empty()) return;
    const Material& material = *surface.material;
    const SurfaceThickness* thickness =
        thickness_use(*surface.diffusion) > 0.0f ? surface.diffusion->thickness.get() : nullptr;
    gpu::ProgramDesc desc{.name = "skin.pixels", .vertex = "skin/surface.vert", .fragment = "skin/pixels/surface.frag"};
    if (coloured) desc.defines.emplace_back("COLOURED");
    if (thickness) desc.defines.emplace_back(thickness->map.texture ? "THICKNESS_MAP" : "VERTEX_THICKNESS");
    const gpu::Program& program = frame.shaders.program(desc);
    program.use();
    program.set("base_colour", glm::vec3(material.base_colour));
    program.set("pre_scatter", usable_pre_scatter(material, surface.diffusion->pre_scatter));
    bind_slot(program, frame.gpu_scene, "base_colour_map", material.base_colour_texture);
    if (thickness && thickness->map.texture) {
        program.set("map_m", thickness->map_m);
        bind_slot(program, frame.gpu_scene, "thickness_map", thickness->map);
    } else if (thickness) {
        program.set("metres", std::cbrt(std::abs(glm::determinant(glm::mat3(surface.transform)))));
        program.texture("thicknesses", vertices_of(surface), {.filter = gpu::Filter::nearest});
    }
    draw_seen_mesh(program, surface, frame);
}

const gpu::Texture& SurfacePixelsPass::vertices_of(const Surface& surface) {
    Vertices& vertices = vertices_.at(surface.mesh->id);
    if (vertices.made_from != surface.diffusion->thickness) {
        std::vector<float> list = surface.diffusion->thickness->vertices;
        const int rows = std::max(1, (int(list.size()) + kColumns - 1) / kColumns);
        list.resize(size_t(rows) * kColumns);
        vertices.list = gpu::Texture({.format = gpu::Format::r32f, .width = kColumns, .height = rows}, "skin.vertices");
        vertices.list.upload(0, 0, list.data());
        vertices.made_from = surface.diffusion->thickness;
    }
    return vertices.list;
}

}  // namespace tyndall::skin
