#include "paint/paint_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/parallel.h"
#include "geometry/surface_points.h"
#include "interior_block.h"
#include "physics/half_space.h"
#include "physics/physics.h"
#include "scene/texture_lookup.h"
#include "splats.h"

namespace tyndall::translucency {
namespace {

constexpr int kLevels = 10;  ///< 2 to this power points that hear from each other
constexpr int kRounds = 6;
/// Where hardly anything is open the kernel's scale means nothing; it stays within this.
constexpr float kMostScale = 16.0f;
/// Rounds of filling what lies between the points: few are needed, since they are even.
constexpr int kMostWidening = 32;
/// Closed points count little for what is known where it is open.
constexpr float kClosedWeight = 1e-3f;

glm::vec4 paint_at(const Paint& paint, const Mesh& mesh, size_t triangle, const glm::vec3& barycentric) {
    glm::vec4 at(paint.colour, paint.cover);
    const TextureSlot& slot = paint.texture;
    if (!slot.texture) return at;
    glm::vec2 uv(0.0f);
    if (!mesh.uv0.empty())
        for (int i = 0; i < 3; ++i) uv += barycentric[i] * mesh.uv0[mesh.indices[3 * triangle + size_t(i)]];
    const glm::vec3 looked_up = slot.uv_transform * glm::vec3(uv, 1.0f);
    at *= sample_texture(*slot.texture, glm::vec2(looked_up), slot.texture->wrap_u, slot.texture->wrap_v);
    return glm::clamp(at, 0.0f, 1.0f);
}

/// Calls `visit(place, area, barycentric)` for pieces of a triangle that are smaller than `side`.
template <class Visit>
void for_pieces(const Mesh& mesh, size_t triangle, float side, const Visit& visit) {
    glm::vec3 corners[3];
    for (size_t i = 0; i < 3; ++i) corners[i] = mesh.positions[mesh.indices[3 * triangle + i]];
    const float area = 0.5f * glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    if (!(area > 0.0f) || !std::isfinite(area)) return;
    const int n = std::clamp(int(std::ceil(std::sqrt(area) / side)), 1, 512);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < 2 * (n - i) - 1; ++j) {  // upright ones and, between them, those upside down
            const float third = (j & 1) != 0 ? 2.0f / 3.0f : 1.0f / 3.0f;
            const glm::vec2 at = (glm::vec2(float(i), float(j / 2)) + third) / float(n);
            const glm::vec3 barycentric(1.0f - at.x - at.y, at.x, at.y);
            visit(corners[0] * barycentric.x + corners[1] * barycentric.y + corners[2] * barycentric.z,
                  area / float(n * n), barycentric);
        }
}

/// The open share of the surface, and the mean colour of what is painted.
struct Cover {
    std::vector<float> open;
    std::vector<size_t> voxels;  ///< those that places of the surface look at
    glm::vec3 colour{0.0f};
};

Cover cover_of(const Mesh& mesh, const Paint& paint, const SurfaceGrid& grid) {
    Splats<float> splats(grid);
    glm::dvec3 colour(0.0);
    double painted = 0.0;
    for (size_t t = 0; t < mesh.triangle_count(); ++t)
        for_pieces(mesh, t, 0.4f * grid.voxel, [&](const glm::vec3& place, float area, const glm::vec3& barycentric) {
            const glm::vec4 here = paint_at(paint, mesh, t, barycentric);
            splats.add(place, 1.0f - here.w, area);
            colour += double(area * here.w) * glm::dvec3(here);
            painted += double(area * here.w);
        });
    Cover cover;
    for (size_t i = 0; i < grid.count(); ++i)
        if (splats.knows(i)) cover.voxels.push_back(i);
    splats.widen();
    cover.open = splats.means();
    cover.colour = glm::vec3(colour / std::max(painted, 1e-30));
    return cover;
}

/// The kernel between the points, each row's sum 1, looked up by the root of the distance.
class Hearing {
 public:
    Hearing(const std::vector<SurfacePoint>& points, const PaintedBody& body, float farthest)
        : points_(points), per_unit_(1.0f / farthest) {
        float area = 0.0f;
        for (const SurfacePoint& point : points) area += point.area;
        const float piece = body.metres * std::sqrt(area / float(points.size()) / std::numbers::pi_v<float>);
        const RadialKernel kernel(body.optics, body.model, Scaling::exact, piece);
        for (int i = 0; i <= kColumns; ++i) {
            const float x = float(i) / kColumns;
            table_.push_back(kernel.at(x * x * farthest * body.metres));
        }
        rows_.assign(points.size(), glm::vec3(1.0f));
        rows_ = of(std::vector<glm::vec3>(points.size(), glm::vec3(1.0f)));
    }
    /// What each point hears of values at all of them.
    [[nodiscard]] std::vector<glm::vec3> of(const std::vector<glm::vec3>& values) const {
        std::vector<glm::vec3> heard(points_.size());
        parallel_for(0, points_.size(), 64, [&](size_t first, size_t last) {
            for (size_t i = first; i < last; ++i) {
                glm::vec3 sum(0.0f);
                for (size_t j = 0; j < points_.size(); ++j)
                    sum +=
                        kernel(glm::distance(points_[i].position, points_[j].position)) * (points_[j].area * values[j]);
                heard[i] = sum / glm::max(rows_[i], glm::vec3(1e-20f));
            }
        });
        return heard;
    }

 private:
    static constexpr int kColumns = 1024;
    [[nodiscard]] glm::vec3 kernel(float distance) const {
        const float column = std::sqrt(std::min(distance * per_unit_, 1.0f)) * kColumns;
        const int i = std::min(int(column), kColumns - 1);
        return glm::max(glm::mix(table_[size_t(i)], table_[size_t(i) + 1], column - float(i)), glm::vec3(0.0f));
    }
    const std::vector<SurfacePoint>& points_;
    float per_unit_;
    std::vector<glm::vec3> table_, rows_;
};

/// Turns the open share that places hear of into T.
void make_leaving(std::vector<glm::vec3>& shares, const PaintedBody& body, const glm::vec3& colour) {
    const glm::vec3 returned =
        physics::HalfSpace(body_albedo(body.optics, body.radius), body.optics.eta).diffuse_leaving();
    const glm::vec3 inside = (1.0f - returned) / glm::max(returned, glm::vec3(1e-6f));
    const glm::vec3 absorbed = (1.0f - colour) / physics::diffuse_transmission(body.optics.eta);
    for (glm::vec3& open : shares)
        open *= (1.0f + inside) / glm::max(inside + open + (1.0f - open) * absorbed, glm::vec3(1e-6f));
}

}  // namespace

Paint paint_of(const Material& boundary) {
    return {boundary.paint_cover, boundary.paint_colour, boundary.paint_texture};
}

PaintGrid make_paint_grid(const Mesh& mesh, const Paint& paint, const PaintedBody& body, int resolution) {
    const std::vector<SurfacePoint> points = sample_surface(mesh, kLevels);
    if (points.empty()) return {};
    const SurfaceGrid grid(mesh.bounds, resolution);
    const Cover cover = cover_of(mesh, paint, grid);
    std::vector<glm::vec3> open(points.size(), glm::vec3(0.0f)), scales(points.size()), spoken(points.size());
    for (size_t i = 0; i < points.size(); ++i)
        grid.about(points[i].position, [&](size_t v, float share) { open[i] += share * cover.open[v]; });
    const Hearing hearing(points, body, glm::distance(mesh.bounds.low, mesh.bounds.high));
    std::vector<glm::vec3> leaving = hearing.of(open);
    std::ranges::fill(scales, glm::vec3(1.0f));
    make_leaving(leaving, body, cover.colour);
    for (int round = 0; round < kRounds; ++round) {
        for (size_t i = 0; i < points.size(); ++i) spoken[i] = scales[i] * open[i];
        const std::vector<glm::vec3> heard = hearing.of(spoken);
        for (size_t i = 0; i < points.size(); ++i)
            scales[i] = glm::clamp(glm::sqrt(scales[i] * leaving[i] / glm::max(heard[i], glm::vec3(1e-6f))),
                                   1.0f / kMostScale, kMostScale);
    }
    Splats<glm::vec3> ends(grid), shares(grid);
    for (size_t i = 0; i < points.size(); ++i) {
        const float weight = open[i].x + kClosedWeight;
        ends.add(points[i].position, scales[i], weight);
        shares.add(points[i].position, leaving[i], weight);
    }
    const auto unknown = [&](size_t voxel) { return !ends.knows(voxel); };
    for (int i = 0; i < kMostWidening && (i < 2 || std::ranges::any_of(cover.voxels, unknown)); ++i) {
        ends.widen();
        shares.widen();
    }
    PaintGrid made{grid.box, grid.size, {}, {}};
    const std::vector<glm::vec3> end = ends.means(), share = shares.means();
    for (size_t i = 0; i < end.size(); ++i) {
        made.ends.emplace_back(end[i], cover.open[i]);
        made.even.emplace_back(share[i], 1.0f);
    }
    return made;
}

}  // namespace tyndall::translucency
