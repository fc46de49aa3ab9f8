#include "htsm/solid.h"

#include <algorithm>
#include <cmath>

#include "core/log.h"
#include "scene/scattering_components.h"

namespace tyndall::translucency {
namespace {

/// Of the lines through a mesh, so many may be open before it is said: scans have small holes.
constexpr float kOpen = 0.01f;

void upload(const glm::ivec3& size, const std::vector<float>& values, gpu::Texture& texture, std::string_view label) {
    const gpu::TextureDesc desc{
        .shape = gpu::Shape::volume, .format = gpu::Format::r32f, .width = size.x, .height = size.y, .layers = size.z};
    if (texture.name() == 0 || texture.desc() != desc) texture = gpu::Texture(desc, label);
    const size_t slice = size_t(size.x) * size_t(size.y);
    for (int z = 0; z < size.z; ++z) texture.upload(0, z, &values[size_t(z) * slice]);
}

}  // namespace

glm::vec4 transport_of(const ScatteringInterior& interior, float longest, float chosen) {
    const glm::vec3 reduced = interior.sigma_s_per_m * (glm::vec3(1.0f) - mean_cosine(interior.phase));
    const glm::vec3 decay = glm::sqrt(3.0f * interior.sigma_a_per_m * (interior.sigma_a_per_m + reduced));
    const float mean = (decay.x + decay.y + decay.z) / 3.0f;
    const float distance = chosen > 0.0f ? chosen : std::min(1.0f / std::max(mean, 1e-9f), longest);
    return {glm::exp(-decay * distance), distance};
}

bool Solid::update(const Surface& surface, double time_s, const HtsmSettings& settings) {
    const bool new_grid = surface.mesh->id != mesh_ || settings.resolution != resolution_;
    if (new_grid) make_grid(surface, settings.resolution);
    if (grid_.size == glm::ivec3(0)) return false;
    const DensityField& density = surface.interior->density;
    if (new_grid || !same_density(density, density_) ||
        (moves_with_world(density) && (surface.transform != transform_ || time_s != time_s_)))
        make_density(surface, time_s);
    phase_.update(surface.interior->phase);
    make_block(surface, settings.transport_distance_m);
    return radius_m_ > 0.0f;
}

void Solid::make_grid(const Surface& surface, int resolution) {
    mesh_ = surface.mesh->id;
    resolution_ = resolution;
    grid_ = make_object_grid(surface.mesh->mesh, resolution);
    const std::string& name = surface.material->name;
    if (grid_.size == glm::ivec3(0)) {
        log::warning("translucency: {}: the mesh {} encloses nothing: it is drawn plainly", name, surface.mesh->name);
        return;
    }
    if (grid_.open_share > kOpen)
        log::warning("translucency: {}: the mesh {} is open: {:.0f} % of the lines through it do not leave it again",
                     name, surface.mesh->name, double(100.0f * grid_.open_share));
    upload(grid_.size, grid_.inside, inside_, "translucency.inside");
    log::info("translucency: {}: a grid of {} x {} x {}, {:.1f} MB", name, grid_.size.x, grid_.size.y, grid_.size.z,
              double(grid_.count() * sizeof(glm::vec2)) / 1048576.0);
}

void Solid::make_density(const Surface& surface, double time_s) {
    ++version_;
    density_ = surface.interior->density;
    transform_ = surface.transform;
    time_s_ = time_s;
    if (const auto* grid = std::get_if<GridDensity>(&density_); grid && !grid->volume)
        log::debug("translucency: {}: its volume is still missing", surface.material->name);
    fill_density(grid_, DensityEvaluator(density_, surface.transform, time_s));
    std::vector<float> marched = grid_.density;
    for (size_t i = 0; i < marched.size(); ++i) marched[i] *= std::min(grid_.inside[i] / kInsideAll, 1.0f);
    upload(grid_.size, marched, densities_, "translucency.density");
}

void Solid::make_block(const Surface& surface, float transport_distance) {
    const ScatteringInterior& interior = *surface.interior;
    const glm::mat4 world_from_unit = surface.transform * glm::inverse(grid_.to_unit_box());
    const glm::vec3 sides(glm::length(glm::vec3(world_from_unit[0])), glm::length(glm::vec3(world_from_unit[1])),
                          glm::length(glm::vec3(world_from_unit[2])));
    const glm::vec3 voxel = sides / glm::vec3(grid_.size);
    const glm::vec3 extinction = interior.sigma_s_per_m + interior.sigma_a_per_m;
    // flattened to nothing by its transform, there is no inside
    radius_m_ = std::abs(glm::determinant(glm::mat3(world_from_unit))) > 0.0f ? 0.5f * glm::length(sides) : 0.0f;
    if (radius_m_ == 0.0f) {
        if (!flat_)
            log::warning("translucency: {}: it is scaled to nothing: it is drawn plainly", surface.material->name);
        flat_ = true;
        return;
    }
    flat_ = false;
    SolidBlock block{};
    block.unit_from_world = glm::inverse(world_from_unit);
    block.world_from_unit = world_from_unit;
    block.scattering_eta = glm::vec4(interior.sigma_s_per_m, interior.eta);
    block.extinction_guide = glm::vec4(extinction, (extinction.x + extinction.y + extinction.z) / 3.0f);
    block.voxel_cast.x = std::cbrt(voxel.x * voxel.y * voxel.z);
    block.voxel_cast.y = surface.casts_shadow ? 1.0f : 0.0f;
    block.transport = transport_of(interior, 2.0f * radius_m_, transport_distance);
    block.most_phase = phase_.most();
    if (buffer_.name() == 0) buffer_ = gpu::Buffer(sizeof block, nullptr, "translucency.solid");
    buffer_.update(0, sizeof block, &block);
    block_ = block;
}

void Solid::bind(const gpu::Program& program) const {
    program.block("Solid", buffer_);
    program.texture("solid_density", densities_, {.filter = gpu::Filter::linear});
    program.texture("solid_inside", inside_, {.filter = gpu::Filter::linear});
    phase_.bind(program);
}

}  // namespace tyndall::translucency
