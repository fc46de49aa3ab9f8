#include "light_volumes/light_meshes.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>

#include "render/shadow_maps.h"

namespace tyndall::participating_media {
namespace {

/// Metres along the view's axis that enclose the box. In coarse steps: a mesh is not made again for every motion.
float reach_of(const ShadowView& view, const Bounds& world) {
    float farthest = 1.0f;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 p((corner & 1) != 0 ? world.high.x : world.low.x,
                          (corner & 2) != 0 ? world.high.y : world.low.y,
                          (corner & 4) != 0 ? world.high.z : world.low.z);
        farthest = std::max(farthest, axis_distance(view, p));
    }
    return std::exp2(std::ceil(std::log2(1.05f * farthest) * 4.0f) / 4.0f);
}

std::vector<float> read_depths(const gpu::Texture& maps, const ShadowView& view) {
    std::vector<float> depths(static_cast<size_t>(view.size) * static_cast<size_t>(view.size));
    glGetTextureSubImage(maps.name(), 0, view.corner.x, view.corner.y, view.page, view.size, view.size, 1,
                         GL_DEPTH_COMPONENT, GL_FLOAT, static_cast<GLsizei>(depths.size() * sizeof(float)),
                         depths.data());
    return depths;
}

}  // namespace

LightMeshes::~LightMeshes() {
    if (vertex_array_ != 0) glDeleteVertexArrays(1, &vertex_array_);
}

bool LightMeshes::has_shadows(const Frame& frame, size_t light) {
    return std::ranges::any_of(frame.shadow_maps.plan().views,
                               [&](const ShadowView& view) { return view.light == light; });
}

void LightMeshes::refresh(Entry& entry, const ShadowView& view, bool of_cube, const gpu::Texture& maps) {
    const ShadowMesh mesh = make_shadow_mesh(view, read_depths(maps, view), entry.reach, entry.detail, of_cube);
    entry.positions = gpu::Buffer(std::span<const glm::vec3>(mesh.positions), "light volume");
    entry.indices = gpu::Buffer(std::span<const uint32_t>(mesh.indices), "light volume");
    entry.index_count = static_cast<int>(mesh.indices.size());
}

void LightMeshes::draw(Frame& frame, size_t light, const Bounds& world, const ShadowMeshDetail& detail) {
    const std::vector<ShadowView>& views = frame.shadow_maps.plan().views;
    if (entries_.size() != views.size()) entries_.resize(views.size());
    if (vertex_array_ == 0) {
        glCreateVertexArrays(1, &vertex_array_);
        glEnableVertexArrayAttrib(vertex_array_, 0);
        glVertexArrayAttribFormat(vertex_array_, 0, 3, GL_FLOAT, GL_FALSE, 0);
        glVertexArrayAttribBinding(vertex_array_, 0, 0);
    }
    glBindVertexArray(vertex_array_);
    const bool of_cube = std::ranges::count(views, light, &ShadowView::light) == 6;
    for (size_t i = 0; i < views.size(); ++i) {
        const bool last = i + 1 == views.size() || views[i + 1].light != light;
        if (views[i].light != light || (!views[i].perspective && !last)) continue;
        Entry& entry = entries_[i];
        const uint64_t version = frame.shadow_maps.version(i);
        const float reach = reach_of(views[i], world);
        if (entry.version != version || entry.reach != reach || entry.detail != detail) {
            entry.version = version;
            entry.reach = reach;
            entry.detail = detail;
            refresh(entry, views[i], of_cube, *frame.shadow_maps.texture());
        }
        glVertexArrayVertexBuffer(vertex_array_, 0, entry.positions.name(), 0, sizeof(glm::vec3));
        glVertexArrayElementBuffer(vertex_array_, entry.indices.name());
        glDrawElements(GL_TRIANGLES, entry.index_count, GL_UNSIGNED_INT, nullptr);
    }
}

}  // namespace tyndall::participating_media
