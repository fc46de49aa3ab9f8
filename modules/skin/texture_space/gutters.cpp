#include "texture_space/gutters.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <utility>

namespace tyndall::skin {
namespace {

float cross(const glm::vec2& a, const glm::vec2& b) {
    return a.x * b.y - a.y * b.x;
}

/// A border edge on the map.
struct Edge {
    glm::vec2 begin{0.0f}, along{0.0f};  ///< texels
    Metric metric;                       ///< at its middle
    float inside = 1.0f;                 ///< the sign of the cross product with `along` that the chart lies on

    /// From texels off `begin` to the tangent plane: share of the edge's length along it; away from the chart in
    /// lengths of the edge across it.
    [[nodiscard]] glm::mat2 to_plane() const {
        const glm::vec2 g = metric.matrix() * along;
        const float length2 = std::max(glm::dot(along, g), 1e-30f);
        const float across = -inside * std::sqrt(std::max(metric.determinant(), 1e-30f)) / length2;
        return glm::transpose(glm::mat2(g / length2, across * glm::vec2(-along.y, along.x)));
    }
};

/// Finds for the texels outside of charts the nearest border and what lies across it.
class GutterMaker {
 public:
    GutterMaker(const Mesh& mesh, const Charts& charts, const std::vector<Metric>& metrics,
                const std::vector<uint32_t>& owners, Atlas& atlas)
        : mesh_(mesh),
          charts_(charts),
          metrics_(metrics),
          owners_(owners),
          atlas_(atlas),
          numbers_(owners.size(), -1) {}

    void run() {
        for (const ChartBorder& border : charts_.borders)
            if (border.twin >= 0) cross_border(border);
        take_steps_of_the_inside();
        pad();
        for (GutterTexel& gutter : atlas_.gutters) find_taps(gutter);
    }

 private:
    struct Found {
        GutterTexel texel;
        glm::vec2 border{0.0f};  ///< the nearest place of it
        float distance = 0.0f;   ///< to there, texels
    };

    [[nodiscard]] bool on_map(const glm::ivec2& at) const {
        return at.x >= 0 && at.y >= 0 && at.x < atlas_.extent() && at.y < atlas_.extent();
    }
    [[nodiscard]] uint32_t owner(const glm::ivec2& at) const { return on_map(at) ? owners_[atlas_.index(at)] : 0; }
    [[nodiscard]] Edge edge_of(const ChartBorder& border, uint32_t begin, uint32_t end) const {
        Edge edge;
        edge.begin = atlas_.place(mesh_.uv0[begin]);
        edge.along = atlas_.place(mesh_.uv0[end]) - edge.begin;
        edge.metric = mix(metrics_[begin], metrics_[end], 0.5f);
        edge.inside = cross(edge.along, atlas_.place(mesh_.uv0[border.opposite]) - edge.begin) >= 0.0f ? 1.0f : -1.0f;
        return edge;
    }

    void cross_border(const ChartBorder& border) {
        const ChartBorder& twin = charts_.borders[size_t(border.twin)];
        const Edge edge = edge_of(border, border.vertices[0], border.vertices[1]);
        const Edge other = edge_of(twin, twin.vertices[1], twin.vertices[0]);  // goes the other way
        if (edge.along == glm::vec2(0.0f) || other.along == glm::vec2(0.0f)) return;
        const glm::mat2 to_other =
            glm::inverse(other.to_plane()) * glm::mat2(1.0f, 0.0f, 0.0f, -1.0f) * edge.to_plane();
        const glm::vec2 end = edge.begin + edge.along;
        const glm::ivec2 low = glm::max(glm::ivec2(glm::floor(glm::min(edge.begin, end))) - kGutterTexels, 0);
        const glm::ivec2 high =
            glm::min(glm::ivec2(glm::floor(glm::max(edge.begin, end))) + kGutterTexels, atlas_.extent() - 1);
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x) {
                const glm::ivec2 at(x, y);
                if (owner(at) != 0) continue;
                const glm::vec2 offset = glm::vec2(at) + 0.5f - edge.begin;
                const glm::vec2 source = other.begin + to_other * offset;
                if (shows(source, twin.chart)) offer(at, edge, offset, source, border.chart);
            }
    }

    /// Whether a bilinear lookup there finds a texel of the chart.
    [[nodiscard]] bool shows(const glm::vec2& source, uint32_t chart) const {
        const glm::ivec2 low(glm::floor(source - 0.5f));
        return owner(low) == chart || owner(low + 1) == chart || owner(low + glm::ivec2(1, 0)) == chart ||
               owner(low + glm::ivec2(0, 1)) == chart;
    }

    /// Keeps it where no border is nearer.
    void offer(const glm::ivec2& at, const Edge& edge, const glm::vec2& offset, const glm::vec2& source,
               uint32_t chart) {
        const float share = std::clamp(glm::dot(offset, edge.along) / glm::dot(edge.along, edge.along), 0.0f, 1.0f);
        const float distance = glm::distance(offset, share * edge.along);
        if (distance > float(kGutterTexels)) return;
        int& number = numbers_[atlas_.index(at)];
        if (number >= 0 && distance >= found_[size_t(number)].distance) return;
        if (number < 0) {
            number = int(found_.size());
            found_.emplace_back();
        }
        found_[size_t(number)] = {{at, source, {}, chart, {}, {}}, edge.begin + share * edge.along, distance};
    }

    /// The texel of a chart nearest to a place at its border; -1 without one near by.
    [[nodiscard]] int nearest_texel(const glm::vec2& to, uint32_t chart, int reach) const {
        const glm::ivec2 middle(glm::floor(to));
        float least = std::numeric_limits<float>::max();
        int nearest = -1;
        for (int y = middle.y - reach; y <= middle.y + reach; ++y)
            for (int x = middle.x - reach; x <= middle.x + reach; ++x) {
                const glm::ivec2 at(x, y);
                const uint32_t there = owner(at);
                const float distance = glm::distance(glm::vec2(at) + 0.5f, to);
                if (there == 0 || (chart != 0 && there != chart) || distance >= least) continue;
                least = distance;
                nearest = int(atlas_.index(at));
            }
        return nearest;
    }

    void take_steps_of_the_inside() {
        std::vector<int> texel_at(owners_.size(), -1);
        for (size_t i = 0; i < atlas_.texels.size(); ++i) texel_at[atlas_.index(atlas_.texels[i].at)] = int(i);
        for (Found& found : found_) {
            const int nearest = nearest_texel(found.border, found.texel.chart, 2);
            if (nearest < 0) continue;
            found.texel.steps = atlas_.texels[size_t(texel_at[size_t(nearest)])].steps;
            atlas_.gutters.push_back(found.texel);
        }
        std::ranges::sort(atlas_.gutters, {}, [](const GutterTexel& g) { return std::pair(g.at.y, g.at.x); });
    }

    /// Texels beside a chart that have nothing yet, so that bilinear lookups at its border find something.
    void pad() {
        std::vector<uint8_t> has(owners_.size(), 0);
        for (const GutterTexel& gutter : atlas_.gutters) has[atlas_.index(gutter.at)] = 1;
        for (int y = 0; y < atlas_.extent(); ++y)
            for (int x = 0; x < atlas_.extent(); ++x) {
                const glm::ivec2 at(x, y);
                if (owner(at) != 0 || has[atlas_.index(at)] != 0) continue;
                const int nearest = nearest_texel(glm::vec2(at) + 0.5f, 0, 1);
                if (nearest < 0) continue;
                GutterTexel gutter;
                gutter.at = at;
                gutter.source = glm::vec2(nearest % atlas_.extent(), nearest / atlas_.extent()) + 0.5f;
                atlas_.gutters.push_back(gutter);
                ++atlas_.padding;
            }
    }

    /// Where a texel of a lookup is not covered, what it shows across the border takes its place: else what lies there
    /// would be as far off as the border is from the first texel's middle.
    void find_taps(GutterTexel& gutter) const {
        const glm::vec2 place = gutter.source - 0.5f, low = glm::floor(place), f = place - low;
        float sum = 0.0f;
        for (int i = 0; i < 4; ++i) {
            const glm::ivec2 corner(i % 2, i / 2), tap = glm::ivec2(low) + corner;
            float weight = (corner.x == 0 ? 1.0f - f.x : f.x) * (corner.y == 0 ? 1.0f - f.y : f.y);
            glm::ivec2 covered = tap;
            if (owner(tap) == 0) {
                const int number = on_map(tap) ? numbers_[atlas_.index(tap)] : -1;
                if (gutter.chart == 0 || number < 0) weight = 0.0f;
                if (number >= 0) covered = across(found_[size_t(number)].texel.source);
            }
            gutter.taps[size_t(i)] = glm::clamp(covered, 0, atlas_.extent() - 1);
            gutter.weights[size_t(i)] = weight;
            sum += weight;
        }
        for (float& weight : gutter.weights) weight /= std::max(sum, 1e-6f);
        if (sum > 1e-6f) return;
        gutter.taps[0] = across(gutter.source);
        gutter.weights = {1.0f, 0.0f, 0.0f, 0.0f};
    }

    [[nodiscard]] glm::ivec2 across(const glm::vec2& source) const {
        const int nearest = std::max(nearest_texel(source, 0, 1), 0);
        return {nearest % atlas_.extent(), nearest / atlas_.extent()};
    }

    const Mesh& mesh_;
    const Charts& charts_;
    const std::vector<Metric>& metrics_;
    const std::vector<uint32_t>& owners_;
    Atlas& atlas_;
    std::vector<Found> found_;
    std::vector<int> numbers_;  ///< into found_ for each texel of the map, -1 = none
};

}  // namespace

void add_gutters(const Mesh& mesh, const Charts& charts, const std::vector<Metric>& metrics,
                 const std::vector<uint32_t>& owners, Atlas& atlas) {
    GutterMaker(mesh, charts, metrics, owners, atlas).run();
}

}  // namespace tyndall::skin
