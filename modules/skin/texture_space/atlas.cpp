#include "texture_space/atlas.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <tuple>

#include "texture_space/charts.h"
#include "texture_space/gutters.h"
#include "texture_space/metric.h"

namespace tyndall::skin {
namespace {

/// Texels come in tiles of this side, so that those near to each other in the list are so on the surface.
constexpr int kTile = 8;
/// Places on the map in parts of a texel: sums of them are exact, so that a texel on the edge of two triangles belongs
/// to one of them.
constexpr double kParts = 1024.0;
struct FinePoint {
    int64_t x = 0, y = 0;
};

int64_t cross(const FinePoint& a, const FinePoint& b, const FinePoint& p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// A triangle that turns the positive way, and calls for each texel whose middle it holds.
class TexelTriangle {
 public:
    TexelTriangle(const std::array<glm::vec2, 3>& corners) {
        for (size_t i = 0; i < 3; ++i)
            corners_[i] = {std::llround(double(corners[i].x) * kParts), std::llround(double(corners[i].y) * kParts)};
        area_ = cross(corners_[0], corners_[1], corners_[2]);
        mirrored_ = area_ < 0;
        if (mirrored_) std::swap(corners_[1], corners_[2]);
        area_ = std::abs(area_);
    }

    template <class Body>
    void for_each_texel(int size, const Body& body) const {
        if (area_ == 0) return;
        const auto [low_x, high_x] = std::minmax({corners_[0].x, corners_[1].x, corners_[2].x});
        const auto [low_y, high_y] = std::minmax({corners_[0].y, corners_[1].y, corners_[2].y});
        const auto texel = [size](int64_t fine) { return std::clamp(int(fine / int64_t(kParts)), 0, size - 1); };
        for (int y = texel(low_y); y <= texel(high_y); ++y)
            for (int x = texel(low_x); x <= texel(high_x); ++x) {
                glm::vec3 shares;
                if (holds({int64_t((x + 0.5) * kParts), int64_t((y + 0.5) * kParts)}, shares))
                    body(glm::ivec2(x, y), shares);
            }
    }

 private:
    /// Of points on an edge those hold that have the triangle below or to the right.
    static bool takes_edge(const FinePoint& a, const FinePoint& b) { return a.y == b.y ? b.x > a.x : b.y < a.y; }
    bool holds(const FinePoint& p, glm::vec3& shares) const {
        std::array<int64_t, 3> areas{};
        for (size_t i = 0; i < 3; ++i) {
            const FinePoint &a = corners_[(i + 1) % 3], &b = corners_[(i + 2) % 3];
            areas[i] = cross(a, b, p);
            if (areas[i] < 0 || (areas[i] == 0 && !takes_edge(a, b))) return false;
        }
        if (mirrored_) std::swap(areas[1], areas[2]);
        shares = glm::vec3(float(areas[0]), float(areas[1]), float(areas[2])) / float(area_);
        return true;
    }

    std::array<FinePoint, 3> corners_;
    int64_t area_ = 0;
    bool mirrored_ = false;
};

/// The whole-numbered tile that all UVs lie in, or the problem.
std::string find_tile(const Mesh& mesh, glm::vec2& tile) {
    glm::vec2 low(1e30f), high(-1e30f);
    for (const glm::vec2& uv : mesh.uv0) {
        if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) return "it has UVs that are not numbers";
        low = glm::min(low, uv);
        high = glm::max(high, uv);
    }
    constexpr float kBeyond = 1e-3f;
    tile = glm::floor(low + kBeyond);
    if (glm::all(glm::lessThanEqual(high, tile + 1.0f + kBeyond))) return {};
    return fmt::format(
        "its UVs reach from ({:.3g}, {:.3g}) to ({:.3g}, {:.3g}): a light map needs them within one tile, each place "
        "of the surface with a place of its own",
        low.x, low.y, high.x, high.y);
}

glm::vec3 face_of(const Mesh& mesh, const uint32_t* corner) {
    const glm::vec3& a = mesh.positions[corner[0]];
    const glm::vec3 n = glm::cross(mesh.positions[corner[1]] - a, mesh.positions[corner[2]] - a);
    return n / std::max(glm::length(n), 1e-30f);
}

double area_of(const Mesh& mesh, size_t first, const glm::mat3& shape) {
    const glm::vec3& a = mesh.positions[mesh.indices[first]];
    const glm::vec3 p = shape * (mesh.positions[mesh.indices[first + 1]] - a);
    const glm::vec3 q = shape * (mesh.positions[mesh.indices[first + 2]] - a);
    return 0.5 * double(glm::length(glm::cross(p, q)));
}

/// Fills in the texels and what is known of them; the atlas' size and tile are set.
class AtlasMaker {
 public:
    AtlasMaker(const Mesh& mesh, const glm::mat3& shape, Atlas& atlas)
        : mesh_(mesh),
          shape_(shape),
          atlas_(atlas),
          charts_(find_charts(mesh)),
          metrics_(vertex_metrics(mesh, charts_, atlas.size, shape)),
          owners_(size_t(atlas.extent()) * size_t(atlas.extent()), 0) {}

    void run() {
        atlas_.charts = charts_.count;
        for (size_t first = 0; first < mesh_.indices.size(); first += 3) lay_out(first);
        std::ranges::sort(atlas_.texels, {}, [](const AtlasTexel& t) {
            return std::tuple(t.at.y / kTile, t.at.x / kTile, t.at.y, t.at.x);
        });
        summarise();
        if (atlas_.usable()) add_gutters(mesh_, charts_, metrics_, owners_, atlas_);
    }

 private:
    void lay_out(size_t first) {
        const uint32_t* corner = &mesh_.indices[first];
        std::array<glm::vec2, 3> places;
        for (size_t i = 0; i < 3; ++i) places[i] = atlas_.place(mesh_.uv0[corner[i]]);
        size_t covered = 0;
        TexelTriangle(places).for_each_texel(atlas_.extent(), [&](const glm::ivec2& at, const glm::vec3& shares) {
            ++covered;
            uint32_t& owner = owners_[atlas_.index(at)];
            if (owner != 0) {
                ++covered_again_;
                return;
            }
            owner = charts_.of_triangle[first / 3];
            atlas_.texels.push_back(texel_at(corner, shares, at, owner));
        });
        const double area = area_of(mesh_, first, shape_);
        area_ += area;
        const glm::vec2 a = places[1] - places[0], b = places[2] - places[0];
        if (std::abs(a.x * b.y - a.y * b.x) < 1e-6f) area_without_uv_ += area;
    }

    AtlasTexel texel_at(const uint32_t* corner, const glm::vec3& shares, const glm::ivec2& at, uint32_t chart) const {
        AtlasTexel texel;
        texel.at = at;
        texel.chart = chart;
        Metric metric;
        for (int i = 0; i < 3; ++i) {
            const Metric& part = metrics_[corner[i]];
            texel.position += shares[i] * mesh_.positions[corner[i]];
            texel.normal += shares[i] * mesh_.normals[corner[i]];
            if (!mesh_.curvatures.empty()) texel.curvature += shares[i] * mesh_.curvatures[corner[i]];
            metric.uu += shares[i] * part.uu;
            metric.uv += shares[i] * part.uv;
            metric.vv += shares[i] * part.vv;
        }
        texel.normal /= std::max(glm::length(texel.normal), 1e-12f);
        texel.curvature = std::max(texel.curvature, 0.0f);
        texel.face = face_of(mesh_, corner);
        texel.steps = steps_of(metric);
        texel.area = std::sqrt(std::max(metric.determinant(), 0.0f));
        return texel;
    }

    void summarise() {
        const size_t count = atlas_.texels.size();
        size_t leaning = 0;
        double area = 0.0;
        for (const AtlasTexel& texel : atlas_.texels) {
            const float ratio = texel.steps.lean * texel.steps.along_v / texel.steps.along_u;  // tangent of the angle
            leaning += std::abs(ratio) > 0.0875f ? 1 : 0;
            area += double(texel.area);
        }
        atlas_.leaning = float(leaning) / float(std::max<size_t>(count, 1));
        atlas_.overlap = float(covered_again_) / float(std::max<size_t>(count, 1));
        atlas_.texel_m = float(std::sqrt(area / double(std::max<size_t>(count, 1))));
        constexpr float kOverlap = 0.005f;
        constexpr double kWithout = 0.02;
        if (area_without_uv_ > kWithout * area_)
            atlas_.problem = fmt::format("{:.0f} % of its surface has no area in the UVs",
                                         100.0 * area_without_uv_ / std::max(area_, 1e-30));
        else if (atlas_.overlap > kOverlap)
            atlas_.problem = fmt::format(
                "{:.1f} % of what its UVs cover is covered more than once (mirrored halves?): a light map needs each "
                "place of the surface with a place of its own",
                100.0 * double(atlas_.overlap));
        else if (count == 0)
            atlas_.problem = "its UVs cover no texel of the map";
    }

    const Mesh& mesh_;
    const glm::mat3& shape_;
    Atlas& atlas_;
    Charts charts_;
    std::vector<Metric> metrics_;
    std::vector<uint32_t> owners_;  ///< a chart for each texel of the map, 0 = none
    size_t covered_again_ = 0;
    double area_ = 0.0, area_without_uv_ = 0.0;  ///< m2
};

}  // namespace

Atlas make_atlas(const Mesh& mesh, int size, const glm::mat3& shape) {
    Atlas atlas;
    atlas.size = size;
    if (mesh.uv0.empty())
        atlas.problem = "it has no UVs";
    else if (mesh.normals.empty() || mesh.indices.empty())
        atlas.problem = "it has no triangles with normals";
    else
        atlas.problem = find_tile(mesh, atlas.tile);
    if (atlas.usable()) AtlasMaker(mesh, shape, atlas).run();
    return atlas;
}

}  // namespace tyndall::skin
