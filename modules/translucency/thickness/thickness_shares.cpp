#include "thickness/thickness_shares.h"

#include <epoxy/gl.h>

#include <chrono>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "core/log.h"
#include "render/draw_state.h"
#include "render/frame.h"
#include "thickness/thickness_grid.h"

namespace tyndall::translucency {
namespace {

constexpr int kResolution = 48;
constexpr int kColumns = 2048;

}  // namespace

gpu::Texture table_of_passing(const Optics& optics, Model model, float farthest_m) {
    const RadialKernel kernel(optics, model, Scaling::published, farthest_m);
    std::vector<glm::vec4> row;
    for (int i = 0; i < kColumns; ++i) {
        const float x = float(i) / (kColumns - 1);
        row.emplace_back(1.0f - kernel.share_within(x * x * farthest_m), 0.0f);
    }
    gpu::Texture table({.format = gpu::Format::rgba32f, .width = kColumns}, "translucency.thickness.passing");
    table.upload(0, 0, row.data());
    return table;
}

const ThicknessShares::Grid& ThicknessShares::grid_of(const Surface& surface) {
    const glm::vec3 shape = shape_of(surface.transform);
    Grid& grid = grids_.at(shape_key(surface));
    if (grid.made) return grid;
    const auto begun = std::chrono::steady_clock::now();
    const ThicknessGrid made = make_thickness_grid(stretched(surface.mesh->mesh, shape), kResolution);
    grid.made = true;
    grid.shape = shape;
    if (made.empty()) return grid;
    grid.grid_from_shape = glm::scale(glm::mat4(1.0f), 1.0f / (made.box.high - made.box.low)) *
                           glm::translate(glm::mat4(1.0f), -made.box.low);
    grid.texture = gpu::Texture({.shape = gpu::Shape::volume,
                                 .format = gpu::Format::r32f,
                                 .width = made.size.x,
                                 .height = made.size.y,
                                 .layers = made.size.z},
                                "translucency.thickness");
    const size_t slice = size_t(made.size.x) * size_t(made.size.y);
    for (int z = 0; z < made.size.z; ++z) grid.texture.upload(0, z, made.thickness.data() + size_t(z) * slice);
    log::info("translucency: {}: thickness in {}x{}x{} voxels, {:.2g} of its length on average, {:.2f} s",
              surface.mesh->name, made.size.x, made.size.y, made.size.z,
              made.mean / glm::length(made.box.high - made.box.low),
              std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count());
    return grid;
}

bool ThicknessShares::draw(PassContext& context, const SeenSurface& seen, std::string_view target,
                           const gpu::Texture& passing, float farthest_m) {
    static const gpu::ProgramDesc kDesc{.name = "translucency.thickness.share",
                                        .fragment = "translucency/thickness/share.frag"};
    const Grid& grid = grid_of(*seen.surface);
    if (grid.texture.name() == 0) return false;
    Frame& frame = context.frame();
    const std::string_view targets[] = {target, "scene_depth"};
    context.bind_targets(targets, -1);
    const DrawState state(DepthState::in_front);
    const gpu::Program& program = frame.shaders.program(kDesc);
    program.use();
    bind_frame(program, frame);
    for (const char* read : {"scene_depth", "gbuffer_surface"})
        program.texture(read, context.texture(read), {.filter = gpu::Filter::nearest});
    program.set("number", seen.number);
    program.texture("thickness", grid.texture, {.filter = gpu::Filter::linear});
    program.texture("passing", passing, {.filter = gpu::Filter::nearest});
    const glm::mat4 world_from_shape = world_from_stretched(*seen.surface, grid.shape);
    program.set("grid_from_world", grid.grid_from_shape * glm::inverse(world_from_shape));
    program.set("grid_metres", metres_of_unit(world_from_shape));
    program.set("farthest", farthest_m);
    glEnable(GL_SCISSOR_TEST);
    glScissor(seen.pixels.low.x, seen.pixels.low.y, seen.pixels.size.x, seen.pixels.size.y);
    gpu::draw_fullscreen();
    glDisable(GL_SCISSOR_TEST);
    return true;
}

}  // namespace tyndall::translucency
