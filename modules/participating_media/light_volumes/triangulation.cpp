#include "light_volumes/triangulation.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/vec2.hpp>

namespace tyndall::participating_media {
namespace {

/// A right-angled triangle; a and b are the ends of its longest side.
struct Triangle {
    glm::ivec2 a, b, c;
    [[nodiscard]] glm::ivec2 middle() const { return (a + b) / 2; }
    [[nodiscard]] bool smallest() const { return std::abs(a.x - c.x) + std::abs(a.y - c.y) <= 1; }
    [[nodiscard]] Triangle first() const { return {c, a, middle()}; }
    [[nodiscard]] Triangle second() const { return {b, c, middle()}; }
};

class Triangulator {
 public:
    Triangulator(int quads, float tolerance) : quads_(quads), tolerance_(tolerance), errors_(point({0, quads + 1})) {}

    /// Fills errors_ from the smallest triangles up, so that a triangle's error covers all below it.
    void measure(std::span<const float> heights, const std::function<float(float, float)>& difference) {
        const auto rows = static_cast<uint32_t>(quads_);
        const uint32_t count = rows * rows * 2 - 2, parents = count - rows * rows;
        for (uint32_t i = count; i-- > 0;) {
            const Triangle triangle = numbered(i);
            const uint32_t middle = point(triangle.middle());
            const float between = 0.5f * (heights[point(triangle.a)] + heights[point(triangle.b)]);
            float error = std::max(errors_[middle], difference(between, heights[middle]));
            if (i < parents)
                error = std::max(
                    {error, errors_[point(triangle.first().middle())], errors_[point(triangle.second().middle())]});
            errors_[middle] = error;
        }
    }

    Triangulation result() {
        used_.assign(errors_.size(), false);
        for (const Triangle& root : roots()) split(root);
        for (int i = 0; i < quads_; ++i) add_border({i, 0});
        for (int i = 0; i < quads_; ++i) add_border({quads_, i});
        for (int i = 0; i < quads_; ++i) add_border({quads_ - i, quads_});
        for (int i = 0; i < quads_; ++i) add_border({0, quads_ - i});
        return std::move(result_);
    }

 private:
    [[nodiscard]] uint32_t point(glm::ivec2 at) const { return static_cast<uint32_t>(at.y * (quads_ + 1) + at.x); }
    [[nodiscard]] std::array<Triangle, 2> roots() const {
        const glm::ivec2 low(0), high(quads_);
        return {Triangle{low, high, {quads_, 0}}, Triangle{high, low, {0, quads_}}};
    }
    /// Larger ones first; the two halves of one follow each other.
    [[nodiscard]] Triangle numbered(uint32_t number) const {
        uint32_t path = number + 2;
        Triangle triangle = roots()[1 - (path & 1)];
        while ((path >>= 1) > 1) triangle = (path & 1) != 0 ? triangle.second() : triangle.first();
        return triangle;
    }
    void split(const Triangle& triangle) {
        if (!triangle.smallest() && errors_[point(triangle.middle())] > tolerance_) {
            split(triangle.first());
            split(triangle.second());
            return;
        }
        for (const glm::ivec2 corner : {triangle.a, triangle.b, triangle.c}) {
            result_.triangles.push_back(point(corner));
            used_[point(corner)] = true;
        }
    }
    void add_border(glm::ivec2 at) {
        if (used_[point(at)]) result_.border.push_back(point(at));
    }

    int quads_;
    float tolerance_;
    std::vector<float> errors_;
    std::vector<bool> used_;
    Triangulation result_;
};

}  // namespace

Triangulation triangulate(std::span<const float> heights, int quads, float tolerance,
                          const std::function<float(float, float)>& difference) {
    Triangulator triangulator(quads, tolerance);
    if (tolerance >= 0.0f) triangulator.measure(heights, difference);
    return triangulator.result();
}

}  // namespace tyndall::participating_media
