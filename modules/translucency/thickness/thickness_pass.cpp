#include "thickness/thickness_pass.h"

#include <chrono>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "body_space.h"
#include "core/log.h"
#include "render/frame.h"
#include "render/light_state.h"
#include "render/seams.h"
#include "thickness/thickness_grid.h"

namespace tyndall::translucency {
namespace {

constexpr int kResolution = 48;
/// Of the table of what passes, as light.comp has it: so many that the nearest will do.
constexpr int kColumns = 2048;

gpu::Texture table_of_passing(const Optics& optics, Model model, float farthest) {
    const RadialKernel kernel(optics, model, Scaling::published, farthest);
    std::vector<glm::vec4> row;
    for (int i = 0; i < kColumns; ++i) {
        const float x = float(i) / (kColumns - 1);
        // of a plane lit evenly at this distance: the kernel's integral over it
        row.emplace_back(1.0f - kernel.share_within(x * x * farthest), 0.0f);
    }
    gpu::Texture table({.format = gpu::Format::rgba32f, .width = kColumns}, "translucency.thickness.through");
    table.upload(0, 0, row.data());
    return table;
}

}  // namespace

ThicknessPass::ThicknessPass(std::shared_ptr<TechniquePlan> plan, const TranslucencySettings& settings)
    : plan_(std::move(plan)),
      settings_(settings),
      programs_({.name = "translucency.thickness.light", .compute = "translucency/thickness/light.comp"}) {}

void ThicknessPass::declare(PassDeclaration& declaration) {
    declare_pixels(declaration);
    declaration.after("translucency.tsm");
}

void ThicknessPass::execute(PassContext& context) {
    if (settings_.enabled)
        for (const SeenSurface& seen : seen_surfaces(*plan_, Technique::thickness, context)) render(context, seen);
    objects_.end_frame();
    grids_.end_frame();
}

const ThicknessPass::Grid& ThicknessPass::grid_of(const Surface& surface) {
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

const ThicknessPass::Object& ThicknessPass::object_of(const Surface& surface) {
    Object& object = objects_.of(surface);
    const bool reshaped = object.size.update(surface.mesh->mesh, glm::mat3(surface.transform));
    const Optics optics = optics_of(*surface.interior);
    const bool is_new = object.interior.update(
        {optics, settings_.model, settings_.scaling, mean_free_path(optics), object.size.radius});
    if (is_new || reshaped) {
        object.wrap = wrap_amount(optics, settings_.model, object.size.radius);
        object.farthest = glm::distance(surface.bounds.low, surface.bounds.high);
        object.through = table_of_passing(optics, settings_.model, object.farthest);
    }
    object.interior.paint(plan_->paints().of(surface, settings_.model), surface);
    return object;
}

/// What the scene does not say, by how many mean free paths the body is large: light that scatters much leaves evenly.
glm::vec4 ThicknessPass::lobe_of(const Object& object, const Optics& optics) const {
    const ThicknessSettings& wanted = settings_.thickness;
    const float n = std::max(object.size.radius / mean_free_path(optics), 1e-3f), even = n / (1.0f + n);
    return {wanted.distortion < 0.0f ? even : wanted.distortion, wanted.power < 0.0f ? 1.0f + 4.0f / n : wanted.power,
            wanted.ambient < 0.0f ? even : wanted.ambient, wanted.scale};
}

void ThicknessPass::render(PassContext& context, const SeenSurface& seen) {
    const Surface& surface = *seen.surface;
    const Grid& grid = grid_of(surface);
    if (grid.texture.name() == 0) return;
    const Object& object = object_of(surface);
    Frame& frame = context.frame();
    const size_t lights = frame.scene.lights.size();
    const bool begins = lights == 0 || has_light_all_around(frame.scene);
    if (begins) begin_pixels(context, seen, object.interior, false);
    const glm::mat4 world_from_shape = surface.transform * glm::scale(glm::mat4(1.0f), 1.0f / grid.shape);
    const Bounds& bounds = surface.bounds;
    programs_.begin();
    for (size_t i = 0; i < lights; ++i) {
        const gpu::Program& program = programs_.use(frame, i, [&](const gpu::Program& fresh) {
            frame.seams.bind(Seam::light_transmittance, fresh, context);
            bind_pixels(fresh, context, seen, object.interior);
            fresh.texture("thickness", grid.texture, {.filter = gpu::Filter::linear});
            fresh.texture("through", object.through, {.filter = gpu::Filter::nearest});
            fresh.set("grid_from_world", grid.grid_from_shape * glm::inverse(world_from_shape));
            fresh.set("grid_metres", std::cbrt(std::abs(glm::determinant(glm::mat3(world_from_shape)))));
            fresh.set("farthest", object.farthest);
            fresh.set("wrap_a", object.wrap.a);
            fresh.set("wrap_lift", 0.5f * object.wrap.a * object.wrap.a * object.size.radius);
            fresh.set("wrap_wide", glm::vec3(0.0f));  // light through the body is in their place
            fresh.set("wrap_even", glm::vec3(0.0f));
            fresh.set("lobe", lobe_of(object, optics_of(*surface.interior)));
            fresh.set("body_ball", glm::vec4(bounds.centre(), 0.5f * glm::distance(bounds.low, bounds.high)));
        });
        program.set("light_index", unsigned(i));
        program.set("keeps", begins || i > 0 ? 1.0f : 0.0f);
        dispatch_columns(seen.pixels.size);
    }
}

}  // namespace tyndall::translucency
