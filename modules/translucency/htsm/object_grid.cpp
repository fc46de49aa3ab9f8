#include "htsm/object_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "core/parallel.h"

namespace tyndall::translucency {
namespace {

constexpr int kLines = 4;  ///< across a voxel, in y and in z

/// Where a line along x crosses the mesh, and whether it enters (+1) or leaves (-1).
struct Crossing {
    float x;
    int turn;
};

/// All lines along x, kLines a voxel.
class Lines {
 public:
    Lines(const Mesh& mesh, const ObjectGrid& grid)
        : rows_(grid.size.y * kLines, grid.size.z * kLines),
          low_(grid.box.low.y, grid.box.low.z),
          step_(glm::vec2(grid.voxel().y, grid.voxel().z) / float(kLines)),
          crossings_(size_t(rows_.x) * size_t(rows_.y)) {
        for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
            cross(mesh.positions[mesh.indices[i]], mesh.positions[mesh.indices[i + 1]],
                  mesh.positions[mesh.indices[i + 2]]);
        for (std::vector<Crossing>& line : crossings_)
            std::ranges::sort(line, {}, [](const Crossing& c) { return c.x; });
    }
    [[nodiscard]] const std::vector<Crossing>& at(int y, int z) const {
        return crossings_[size_t(z) * size_t(rows_.x) + size_t(y)];
    }

 private:
    [[nodiscard]] static double side(glm::dvec2 a, glm::dvec2 b, glm::dvec2 p) {
        return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    }
    /// A line through an edge crosses one of the two triangles that share it: ties go by the edge's direction.
    [[nodiscard]] static bool covers(double w, glm::dvec2 a, glm::dvec2 b) {
        return w > 0.0 || (w == 0.0 && (a.y != b.y ? a.y < b.y : a.x < b.x));
    }

    void cross(glm::vec3 p0, glm::vec3 p1, glm::vec3 p2) {
        glm::dvec2 a(p0.y, p0.z), b(p1.y, p1.z), c(p2.y, p2.z);
        double area = side(a, b, c);
        if (area == 0.0) return;
        const int turn = area > 0.0 ? -1 : 1;  // its normal looks along +x: the line leaves
        if (area < 0.0) {
            std::swap(b, c);
            std::swap(p1, p2);
            area = -area;
        }
        const glm::dvec2 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
        const glm::ivec2 first = glm::max(glm::ivec2(glm::ceil((low - low_) / step_ - 0.5)), glm::ivec2(0));
        const glm::ivec2 last = glm::min(glm::ivec2(glm::floor((high - low_) / step_ - 0.5)), rows_ - 1);
        for (int z = first.y; z <= last.y; ++z)
            for (int y = first.x; y <= last.x; ++y) {
                const glm::dvec2 p = low_ + (glm::dvec2(y, z) + 0.5) * step_;
                const double u = side(b, c, p), v = side(c, a, p), w = side(a, b, p);
                if (!covers(u, b, c) || !covers(v, c, a) || !covers(w, a, b)) continue;
                const double x = (u * double(p0.x) + v * double(p1.x) + w * double(p2.x)) / area;
                crossings_[size_t(z) * size_t(rows_.x) + size_t(y)].push_back({float(x), turn});
            }
    }

    glm::ivec2 rows_;
    glm::dvec2 low_, step_;
    std::vector<std::vector<Crossing>> crossings_;
};

/// Adds the length from `a` to `b`, in voxels along x, to a row of voxels.
void add_length(float* row, int count, float a, float b, float weight) {
    a = std::clamp(a, 0.0f, float(count));
    b = std::clamp(b, 0.0f, float(count));
    for (int i = int(a); i < count && float(i) < b; ++i)
        row[i] += weight * (std::min(b, float(i + 1)) - std::max(a, float(i)));
}

/// Returns whether the line left the mesh as often as it entered.
bool add_line(const std::vector<Crossing>& line, float low, float voxel, float* row, int count) {
    constexpr float kWeight = 1.0f / (kLines * kLines);
    int winding = 0;
    for (const Crossing& crossing : line) winding += crossing.turn;
    if (winding != 0) {
        add_length(row, count, (line.front().x - low) / voxel, (line.back().x - low) / voxel, kWeight);
        return false;
    }
    for (size_t i = 0; i + 1 < line.size(); ++i) {
        winding += line[i].turn;
        if (winding != 0) add_length(row, count, (line[i].x - low) / voxel, (line[i + 1].x - low) / voxel, kWeight);
    }
    return true;
}

void fill_inside(ObjectGrid& grid, const Lines& lines) {
    grid.inside.assign(grid.count(), 0.0f);
    size_t crossed = 0, open = 0;
    for (int z = 0; z < grid.size.z * kLines; ++z)
        for (int y = 0; y < grid.size.y * kLines; ++y) {
            const std::vector<Crossing>& line = lines.at(y, z);
            if (line.empty()) continue;
            const size_t row = (size_t(z / kLines) * size_t(grid.size.y) + size_t(y / kLines)) * size_t(grid.size.x);
            ++crossed;
            if (!add_line(line, grid.box.low.x, grid.voxel().x, &grid.inside[row], grid.size.x)) ++open;
        }
    for (float& share : grid.inside) share = std::min(share, 1.0f);
    grid.open_share = crossed > 0 ? float(open) / float(crossed) : 0.0f;
}

}  // namespace

glm::mat4 ObjectGrid::to_unit_box() const {
    return glm::translate(glm::scale(glm::mat4(1.0f), 1.0f / box.size()), -box.low);
}

ObjectGrid make_object_grid(const Mesh& mesh, int resolution) {
    ObjectGrid grid;
    const glm::vec3 extent = mesh.bounds.size();
    if (!(std::min({extent.x, extent.y, extent.z}) > 0.0f) || !std::isfinite(extent.x + extent.y + extent.z))
        return grid;
    const float longest = std::max({extent.x, extent.y, extent.z});
    const glm::ivec3 filled = glm::max(glm::ivec3(glm::ceil(extent / longest * float(resolution) - 1e-3f)), 4);
    const glm::vec3 voxel = extent / glm::vec3(filled);
    grid.size = filled + 2;
    grid.box = {mesh.bounds.low - voxel, mesh.bounds.high + voxel};
    fill_inside(grid, Lines(mesh, grid));
    if (std::ranges::none_of(grid.inside, [](float share) { return share > 0.0f; })) grid.size = glm::ivec3(0);
    return grid;
}

void fill_density(ObjectGrid& grid, const DensityEvaluator& density) {
    grid.density.assign(grid.count(), 1.0f);
    if (density.constant()) return;
    parallel_for(0, size_t(grid.size.z), 1, [&](size_t first, size_t last) {
        for (size_t z = first; z < last; ++z)
            for (int y = 0; y < grid.size.y; ++y)
                for (int x = 0; x < grid.size.x; ++x)
                    grid.density[(z * size_t(grid.size.y) + size_t(y)) * size_t(grid.size.x) + size_t(x)] =
                        density.at(grid.centre(x, y, int(z)));
    });
}

namespace {

bool same(const ConstantDensity&, const ConstantDensity&) {
    return true;
}
bool same(const HeightDensity& a, const HeightDensity& b) {
    return a.base_m == b.base_m && a.scale_height_m == b.scale_height_m;
}
bool same(const BlobDensity& a, const BlobDensity& b) {
    return std::ranges::equal(a.blobs, b.blobs, [](const auto& x, const auto& y) {
        return x.centre == y.centre && x.radius == y.radius && x.weight == y.weight;
    });
}
bool same(const NoiseDensity& a, const NoiseDensity& b) {
    return a.feature_m == b.feature_m && a.octaves == b.octaves && a.coverage == b.coverage &&
           a.wind_m_s == b.wind_m_s && a.kind == b.kind && a.swirl == b.swirl && a.churn_per_s == b.churn_per_s;
}
bool same(const GridDensity& a, const GridDensity& b) {
    return a.volume == b.volume && a.to_volume == b.to_volume && a.scale == b.scale;
}
bool same(const GradientDensity& a, const GradientDensity& b) {
    return a.radial == b.radial && a.from == b.from && a.to == b.to && a.inner == b.inner && a.outer == b.outer &&
           a.start == b.start && a.end == b.end;
}
bool same(const ProductDensity& a, const ProductDensity& b) {
    return same_density(*a.base, *b.base) && a.mask.has_value() == b.mask.has_value() &&
           (!a.mask || same(*a.mask, *b.mask)) && a.layer.has_value() == b.layer.has_value() &&
           (!a.layer || same(*a.layer, *b.layer));
}

}  // namespace

bool same_density(const DensityField& a, const DensityField& b) {
    return a.index() == b.index() &&
           std::visit([&](const auto& field) { return same(field, std::get<std::decay_t<decltype(field)>>(b)); }, a);
}

bool moves_with_world(const DensityField& field) {
    if (const auto* product = std::get_if<ProductDensity>(&field))
        return product->layer.has_value() || moves_with_world(*product->base);
    return std::holds_alternative<HeightDensity>(field) || std::holds_alternative<NoiseDensity>(field);
}

}  // namespace tyndall::translucency
