#include "light_volumes/shadow_mesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include "light_volumes/triangulation.h"

namespace tyndall::participating_media {
namespace {

/// Depth values and metres along a view's axis.
class Axis {
 public:
    explicit Axis(const ShadowView& view)
        : perspective_(view.perspective), inverse_(glm::inverse(view.clip_from_world)) {
        const glm::mat4 rows = glm::transpose(view.clip_from_world);
        depth_per_m_ = glm::length(glm::vec3(rows[2]));
    }
    /// At the middle of the view or anywhere else: planes across the axis are planes of equal depth.
    [[nodiscard]] float metres(float depth) const {
        return perspective_ ? 1.0f / std::max(inverse_[3].w + depth * inverse_[2].w, 1e-9f)
                            : (1.0f - depth) / depth_per_m_;
    }
    [[nodiscard]] float depth(float metres) const {
        return perspective_ ? (1.0f / metres - inverse_[3].w) / inverse_[2].w : 1.0f - metres * depth_per_m_;
    }
    [[nodiscard]] glm::vec3 world(glm::vec2 clip, float depth) const {
        const glm::vec4 p = inverse_ * glm::vec4(clip, depth, 1.0f);
        return glm::vec3(p) / p.w;
    }

 private:
    bool perspective_;
    glm::mat4 inverse_;
    float depth_per_m_ = 1.0f;
};

/// Texels at each side of a view that only filters look at, where six make a cube (render/shadow_views.h).
constexpr float kFilterMargin = 3.0f;

/// Where the points of a grid lie in a view.
struct Grid {
    int quads = 1;
    int size = 1;  ///< texels
    bool of_cube = false;

    /// At the middles of texels, so that thin things keep their width; a cube's must end where the next begins.
    [[nodiscard]] glm::vec2 clip(uint32_t point) const {
        const auto columns = static_cast<uint32_t>(quads) + 1;
        const glm::vec2 share = glm::vec2(point % columns, point / columns) / static_cast<float>(quads);
        const auto texels = static_cast<float>(size);
        return of_cube ? (2.0f * share - 1.0f) * (1.0f - 2.0f * kFilterMargin / texels)
                       : 2.0f * share - 1.0f + 1.0f / texels;
    }
};

float bilinear(std::span<const float> depths, int size, glm::vec2 texel, float nothing) {
    const glm::vec2 at = glm::clamp(texel, glm::vec2(0.0f), glm::vec2(static_cast<float>(size - 1)));
    const glm::ivec2 low = glm::min(glm::ivec2(at), glm::ivec2(size - 2));
    const glm::vec2 f = at - glm::vec2(low);
    const auto fetch = [&](int x, int y) {
        const float depth = depths[static_cast<size_t>((low.y + y) * size + low.x + x)];
        return depth > 0.0f ? std::max(depth, nothing) : nothing;
    };
    return glm::mix(glm::mix(fetch(0, 0), fetch(1, 0), f.x), glm::mix(fetch(0, 1), fetch(1, 1), f.x), f.y);
}

/// Planes are linear in depth over the map, so that few triangles are as good as many.
std::vector<float> grid_depths(const Grid& grid, std::span<const float> depths, float nothing) {
    std::vector<float> result(static_cast<size_t>((grid.quads + 1) * (grid.quads + 1)));
    for (uint32_t point = 0; point < result.size(); ++point) {
        const glm::vec2 share = 0.5f + 0.5f * grid.clip(point);
        result[point] = bilinear(depths, grid.size, share * static_cast<float>(grid.size) - 0.5f, nothing);
    }
    return result;
}

/// Writes the used points of a grid, and then what closes the surface.
class MeshWriter {
 public:
    MeshWriter(const Axis& axis, const Grid& grid) : axis_(axis), grid_(grid) {}

    void surface(const Triangulation& triangulation, std::span<const float> depths) {
        vertices_.assign(depths.size(), kNone);
        for (const uint32_t point : triangulation.triangles) {
            if (vertices_[point] == kNone) vertices_[point] = add(axis_.world(grid_.clip(point), depths[point]));
            mesh_.indices.push_back(vertices_[point]);
        }
    }
    void pyramid(const std::vector<uint32_t>& border, const glm::vec3& eye) {
        const uint32_t apex = add(eye);
        for (size_t i = 0; i < border.size(); ++i) triangle(apex, vertices_[border[i]], vertices_[next(border, i)]);
    }
    void lid(const std::vector<uint32_t>& border, float depth) {
        const uint32_t middle = add(axis_.world(glm::vec2(0.0f), depth));
        const auto first = static_cast<uint32_t>(mesh_.positions.size());
        for (const uint32_t point : border) add(axis_.world(grid_.clip(point), depth));
        for (size_t i = 0; i < border.size(); ++i) {
            const uint32_t low = first + static_cast<uint32_t>(i);
            const uint32_t low_next = first + static_cast<uint32_t>((i + 1) % border.size());
            const uint32_t high = vertices_[border[i]], high_next = vertices_[next(border, i)];
            triangle(high, high_next, low_next);
            triangle(high, low_next, low);
            triangle(middle, low, low_next);
        }
    }
    ShadowMesh take() { return std::move(mesh_); }

 private:
    static constexpr uint32_t kNone = ~0u;
    [[nodiscard]] static uint32_t next(const std::vector<uint32_t>& border, size_t i) {
        return border[(i + 1) % border.size()];
    }
    uint32_t add(const glm::vec3& p) {
        mesh_.positions.push_back(p);
        return static_cast<uint32_t>(mesh_.positions.size() - 1);
    }
    void triangle(uint32_t a, uint32_t b, uint32_t c) { mesh_.indices.insert(mesh_.indices.end(), {a, b, c}); }

    const Axis& axis_;
    const Grid& grid_;
    std::vector<uint32_t> vertices_;  // of grid points
    ShadowMesh mesh_;
};

}  // namespace

float axis_distance(const ShadowView& view, const glm::vec3& p) {
    const glm::vec4 clip = view.clip_from_world * glm::vec4(p, 1.0f);
    return view.perspective ? clip.w : Axis(view).metres(clip.z);
}

ShadowMesh make_shadow_mesh(const ShadowView& view, std::span<const float> depths, float reach,
                            const ShadowMeshDetail& detail, bool of_cube) {
    const Axis axis(view);
    const float nothing = axis.depth(reach);
    const int per_quad = std::max(detail.texels_per_quad, 1);
    const int quads = static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::max(view.size / per_quad, 1))));
    const Grid grid{quads, view.size, of_cube};
    const std::vector<float> heights = grid_depths(grid, depths, nothing);
    const Triangulation triangulation = triangulate(heights, quads, detail.tolerance_m, [&](float a, float b) {
        return std::abs(axis.metres(a) - axis.metres(b));
    });
    MeshWriter writer(axis, grid);
    writer.surface(triangulation, heights);
    if (view.perspective)
        writer.pyramid(triangulation.border, view.eye);
    else
        writer.lid(triangulation.border, nothing);
    return writer.take();
}

}  // namespace tyndall::participating_media
