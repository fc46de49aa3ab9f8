#include "paint/body_paint.h"

#include <array>
#include <chrono>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "body_size.h"
#include "core/log.h"

namespace tyndall::translucency {
namespace {

constexpr int kResolution = 48;

gpu::Texture volume_of(glm::ivec3 size, const std::vector<glm::vec4>& voxels) {
    gpu::Texture texture({.shape = gpu::Shape::volume,
                          .format = gpu::Format::rgba32f,
                          .width = size.x,
                          .height = size.y,
                          .layers = size.z},
                         "translucency.paint");
    const size_t slice = size_t(size.x) * size_t(size.y);
    for (int z = 0; z < size.z; ++z) texture.upload(0, z, voxels.data() + size_t(z) * slice);
    return texture;
}

void make(BodyPaint& made, const Surface& surface, Model model) {
    const auto begun = std::chrono::steady_clock::now();
    made.shape = shape_of(surface.transform);
    const Optics optics = optics_of(*surface.interior);
    const PaintedBody body{optics, model, metres_of_unit(world_from_stretched(surface, made.shape)),
                           body_radius(surface.mesh->mesh, glm::mat3(surface.transform))};
    made.closed = body.radius > 0.0f;
    Mesh mesh = stretched(surface.mesh->mesh, made.shape);
    mesh.uv0 = surface.mesh->mesh.uv0;
    if (mesh.uv0.empty() && surface.material->paint_texture.texture)
        log::warning("translucency: {}: a mesh without UVs takes the corner of its paint's texture everywhere",
                     surface.mesh->name);
    const PaintGrid grid = make_paint_grid(mesh, paint_of(*surface.material), body, kResolution);
    if (grid.empty()) return;
    made.grid_from_shape = glm::scale(glm::mat4(1.0f), 1.0f / (grid.box.high - grid.box.low)) *
                           glm::translate(glm::mat4(1.0f), -grid.box.low);
    made.ends = volume_of(grid.size, grid.ends);
    made.even = volume_of(grid.size, grid.even);
    log::info("translucency: {}: paint in {}x{}x{} voxels, {:.2f} s", surface.mesh->name, grid.size.x, grid.size.y,
              grid.size.z, std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count());
}

}  // namespace

const BodyPaint* PaintStore::of(const Surface& surface, Model model) {
    if (!is_painted(surface)) return nullptr;
    const Optics optics = optics_of(*surface.interior);
    const Material& material = *surface.material;
    const float metres = metres_of_unit(world_from_stretched(surface, shape_of(surface.transform)));
    Numbers numbers{optics.eta, std::round(50.0f * std::log2(metres)), material.paint_cover};
    for (size_t i = 0; i < 3; ++i) {
        const auto c = int(i);
        numbers[3 + i] = optics.sigma_s_reduced[c];
        numbers[6 + i] = optics.sigma_a[c];
        numbers[9 + i] = material.paint_colour[c];
    }
    const TextureSlot& slot = material.paint_texture;
    BodyPaint& paint = kept_.at({shape_key(surface), model, slot.texture ? slot.texture->id : 0, numbers});
    if (paint.number == 0) {
        paint.number = ++made_;
        make(paint, surface, model);
    }
    return paint.ends.name() == 0 ? nullptr : &paint;
}

uint64_t PaintStore::number(const Surface& surface, Model model) {
    const BodyPaint* paint = of(surface, model);
    return paint ? paint->number : 0;
}

void PaintBinding::set(const BodyPaint* paint, const Surface& surface) {
    paint_ = paint;
    if (paint) {
        grid_from_world_ = paint->grid_from_shape * glm::inverse(world_from_stretched(surface, paint->shape));
    } else if (open_.name() == 0) {
        open_ = volume_of(glm::ivec3(1), {glm::vec4(1.0f)});
    }
}

void PaintBinding::bind(const gpu::Program& program) const {
    program.texture("paint_ends", paint_ ? paint_->ends : open_, {.filter = gpu::Filter::linear});
    program.texture("paint_even", paint_ ? paint_->even : open_, {.filter = gpu::Filter::linear});
    program.set("paint_from_world", grid_from_world_);
}

}  // namespace tyndall::translucency
