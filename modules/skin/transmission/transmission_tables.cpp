#include "transmission/transmission_tables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/matrix.hpp>

#include "skin_plan.h"

namespace tyndall::skin {
namespace {

constexpr size_t kSurfaceRows = 4;
/// Tables kept, those that are not in use any more among them.
constexpr size_t kMostRows = 64;
constexpr float kLeast = 1e-4f;  // less does not count as coming through

float most(const glm::vec3& value) {
    return std::max({value.x, value.y, value.z});
}

float reach_of(const physics::DiffusionProfile& profile) {
    float reach = 1e-6f;
    while (reach < 1.0f && most(profile.through(reach)) > kLeast) reach *= 1.1f;
    return reach;
}

/// Rows of the transform from the world to the mesh's box as [-1, 1]^3.
std::array<glm::vec4, 3> box_of(const Surface& surface) {
    const Bounds& bounds = surface.mesh->mesh.bounds;
    const glm::vec3 middle = 0.5f * (bounds.low + bounds.high);
    const glm::vec3 half = glm::max(0.5f * (bounds.high - bounds.low), glm::vec3(1e-9f));
    glm::mat4 world_from_box = surface.transform;
    for (int i = 0; i < 3; ++i) world_from_box[i] *= half[i];
    world_from_box[3] = surface.transform * glm::vec4(middle, 1.0f);
    const glm::mat4 rows = glm::transpose(glm::inverse(world_from_box));
    return {rows[0], rows[1], rows[2]};
}

}  // namespace

TransmissionTables::Row TransmissionTables::make(const Source& source) {
    Row row{source, source.through ? source.through->reach_m() : reach_of(source.profile), 0.0f, {}};
    const auto share = [&](float thickness) {
        return source.through ? source.through->at(thickness) : source.profile.through(thickness);
    };
    const glm::vec3 at_0 = glm::max(share(0.0f), glm::vec3(kLeast));
    for (int i = 0; i < kEntries && row.width_m == 0.0f; ++i) {
        const float u = float(i) / float(kEntries - 1);
        if (most(share(row.reach_m * u * u) / at_0) < 0.25f) row.width_m = row.reach_m * u * u;
    }
    for (int i = 0; i < kEntries; ++i) {
        const float u = float(i) / float(kEntries - 1);
        row.shares.emplace_back(i + 1 < kEntries ? share(row.reach_m * u * u) : glm::vec3(0.0f), 0.0f);
    }
    return row;
}

const TransmissionTables::Row& TransmissionTables::row_of(const SurfaceDiffusion& diffusion, size_t& index) {
    const Source wanted{diffusion.through, diffusion.through ? physics::DiffusionProfile{} : diffusion.profile};
    const auto found = std::ranges::find(rows_, wanted, &Row::source);
    index = size_t(found - rows_.begin());
    if (found != rows_.end()) return *found;
    shares_ = {};
    return rows_.emplace_back(make(wanted));
}

void TransmissionTables::bind(const gpu::Program& program, const RenderScene& scene) {
    if (rows_.size() > kMostRows) {
        rows_.clear();
        shares_ = {};
    }
    const size_t width = scene.surfaces.size() + 1;
    std::vector<glm::vec4> texels(kSurfaceRows * width, glm::vec4(0.0f));
    for (size_t i = 0; i < scene.surfaces.size(); ++i) {
        const Surface& surface = scene.surfaces[i];
        if (!surface.diffusion || !has_volume(surface)) continue;
        size_t index = 0;
        const Row& row = row_of(*surface.diffusion, index);
        const std::array<glm::vec4, 3> box = box_of(surface);
        for (size_t r = 0; r < box.size(); ++r) texels[r * width + i + 1] = box[r];
        texels[3 * width + i + 1] = glm::vec4(float(index), row.reach_m, row.width_m, 0.0f);
    }
    if (shares_.name() == 0) {
        shares_ = gpu::Texture({.format = gpu::Format::rgba32f, .width = kEntries, .height = int(rows_.size())},
                               "skin through");
        std::vector<glm::vec4> all;
        for (const Row& row : rows_) all.insert(all.end(), row.shares.begin(), row.shares.end());
        shares_.upload(0, 0, all.data());
    }
    if (texels != surface_texels_ || surfaces_.name() == 0) {
        surfaces_ = gpu::Texture({.format = gpu::Format::rgba32f, .width = int(width), .height = int(kSurfaceRows)},
                                 "skin through surfaces");
        surfaces_.upload(0, 0, texels.data());
        surface_texels_ = std::move(texels);
    }
    program.texture("skin_through", shares_, {.filter = gpu::Filter::nearest});
    program.texture("skin_through_surfaces", surfaces_, {.filter = gpu::Filter::nearest});
}

}  // namespace tyndall::skin
