#include "radiance_maps/balance.h"

#include <cmath>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>
#include <numbers>

#include "core/parallel.h"
#include "geometry/surface_points.h"

namespace tyndall::translucency {
namespace {

constexpr int kLevels = 12;  ///< 2 to this power points
constexpr int kRounds = 6;

/// A kernel by the distance, from a table. Not its Gaussians: where the kernel is narrower than a piece their sum is
/// off by tenths, which would be light from nowhere.
class KernelTable {
 public:
    KernelTable(const RadialKernel& kernel, float farthest) : per_metre_(float(kSteps) / farthest) {
        for (int i = 0; i <= kSteps; ++i) values_.push_back(kernel.exact(float(i) / per_metre_));
    }
    [[nodiscard]] glm::vec3 at(float r) const {
        const float x = std::min(r * per_metre_, float(kSteps) - 1e-3f);
        const auto i = size_t(x);
        return glm::mix(values_[i], values_[i + 1], x - float(i));
    }

 private:
    static constexpr int kSteps = 4096;
    float per_metre_;
    std::vector<glm::vec3> values_;
};

struct Points {
    std::vector<glm::vec3> places;  ///< metres
    std::vector<float> areas;       ///< m2
    std::vector<glm::vec3> normals;
    std::vector<Balanced> balanced;
};

/// The kernel between two points: of a disc as wide as a piece where both lie on one side of the body. What
/// lies above it, or on the other side of a wall thinner than pieces are wide, is as far away from all of a piece as
/// from its middle.
class PieceKernel {
 public:
    PieceKernel(const Optics& optics, Model model, float piece, float farthest)
        : beside_(RadialKernel(optics, model, Scaling::exact, piece), farthest),
          across_(RadialKernel(optics, model, Scaling::exact, kPoint * piece), farthest) {}
    [[nodiscard]] glm::vec3 between(const Points& points, size_t i, size_t j) const {
        const glm::vec3 apart = points.places[j] - points.places[i];
        const float distance = glm::length(apart), steepest = kSteepest * distance;
        const bool beside = glm::dot(points.normals[i], points.normals[j]) > 0.0f &&
                            std::abs(glm::dot(apart, points.normals[i])) <= steepest &&
                            std::abs(glm::dot(apart, points.normals[j])) <= steepest;
        return (beside ? beside_ : across_).at(distance);
    }

 private:
    static constexpr float kPoint = 0.02f;    ///< a disc as good as a point
    static constexpr float kSteepest = 0.5f;  ///< sine between a piece and the way to what still lies beside it
    KernelTable beside_, across_;
};

/// What leaves at a point of a unit of light a unit of area everywhere, not scaled there.
glm::vec3 found_at(size_t i, const Points& points, const PieceKernel& kernel) {
    glm::vec3 sum(0.0f);
    for (size_t j = 0; j < points.places.size(); ++j)
        sum += points.areas[j] * points.balanced[j].scale * kernel.between(points, i, j);
    return sum;
}

void find_normals(size_t i, const Points& points, const PieceKernel& kernel, Balanced& at) {
    glm::mat3 others(0.0f);
    glm::vec3 all(1e-20f);
    for (size_t j = 0; j < points.places.size(); ++j) {
        const glm::vec3 weight = points.areas[j] * points.balanced[j].scale * kernel.between(points, i, j);
        all += weight;
        if (j == i)
            at.own = weight;
        else
            others += glm::outerProduct(points.normals[j], weight);
    }
    at.own /= all;
    for (int c = 0; c < 3; ++c) others[c] /= all[c];
    at.others = (others[0] + others[1] + others[2]) / 3.0f;
    for (int c = 0; c < 3; ++c) at.sizes[c] = (glm::length(others[c]) + 1e-4f) / (glm::length(at.others) + 1e-4f);
}

/// What lies between the points. (The sum at a place between them would not do: kernels are often narrower than
/// pieces.)
class Blend {
 public:
    Blend(const Points& points, float spacing) : points_(points), spacing_(spacing) {
        for (size_t first = 0; first < points.places.size(); first += kTogether) {
            Bounds bounds;
            for (size_t i = first; i < first + kTogether; ++i) bounds.add(points.places[i]);
            balls_.emplace_back(bounds.centre(), bounds.radius());
        }
    }
    [[nodiscard]] Balanced at(const glm::vec3& place) const {
        for (float reach = kReach * spacing_; reach < 1e6f * spacing_; reach *= 4.0f) {
            Balanced sum{glm::vec3(0.0f), glm::vec3(0.0f), glm::vec3(0.0f), glm::vec3(0.0f)};
            float weights = 0.0f;
            for (size_t ball = 0; ball < balls_.size(); ++ball)
                if (glm::distance(place, glm::vec3(balls_[ball])) < balls_[ball].w + reach)
                    add(place, ball * kTogether, reach, sum, weights);
            if (weights > 0.0f)
                return {sum.scale / weights, sum.own / weights, sum.others / weights, sum.sizes / weights};
        }
        return {};
    }

 private:
    static constexpr size_t kTogether = 32;  ///< points that follow one another lie together
    static constexpr float kReach = 3.0f;    ///< spacings

    void add(const glm::vec3& place, size_t first, float reach, Balanced& sum, float& weights) const {
        for (size_t j = first; j < first + kTogether; ++j) {
            const glm::vec3 apart = points_.places[j] - place;
            const float d2 = glm::dot(apart, apart), r2 = d2 / (spacing_ * spacing_);
            const float inside = std::max(1.0f - d2 / (reach * reach), 0.0f);
            const float weight = inside * inside * std::exp(-2.0f * r2);
            sum.scale += weight * points_.balanced[j].scale;
            sum.own += weight * points_.balanced[j].own;
            sum.others += weight * points_.balanced[j].others;
            sum.sizes += weight * points_.balanced[j].sizes;
            weights += weight;
        }
    }

    const Points& points_;
    float spacing_;
    std::vector<glm::vec4> balls_;
};

/// Symmetric balancing (Knight, Ruiz & Ucar).
void scale_evenly(Points& points, const PieceKernel& kernel) {
    for (int round = 0; round < kRounds; ++round) {
        std::vector<Balanced> next(points.places.size());
        parallel_for(0, next.size(), 64, [&](size_t first, size_t last) {
            for (size_t i = first; i < last; ++i)
                next[i].scale =
                    glm::sqrt(points.balanced[i].scale / glm::max(found_at(i, points, kernel), glm::vec3(1e-20f)));
        });
        points.balanced = std::move(next);
    }
}

}  // namespace

std::vector<Balanced> balance(const Mesh& mesh, const Optics& optics, Model model, Scaling scaling,
                              float metres_of_unit) {
    std::vector<Balanced> vertices(mesh.positions.size());
    Points points;
    float area = 0.0f;
    for (const SurfacePoint& point : sample_surface(mesh, kLevels)) {
        points.places.push_back(metres_of_unit * point.position);
        points.areas.push_back(metres_of_unit * metres_of_unit * point.area);
        points.normals.push_back(point.normal);
        area += points.areas.back();
    }
    const size_t count = points.places.size();
    if (count == 0 || !(area > 0.0f)) return vertices;
    points.balanced.resize(count);
    const float piece = std::sqrt(area / (float(count) * std::numbers::pi_v<float>));
    const PieceKernel kernel(optics, model, piece, 1.01f * metres_of_unit * glm::length(mesh.bounds.size()));
    if (scaling == Scaling::exact) scale_evenly(points, kernel);
    parallel_for(0, count, 64, [&](size_t first, size_t last) {
        for (size_t i = first; i < last; ++i) find_normals(i, points, kernel, points.balanced[i]);
    });
    const Blend blend(points, std::sqrt(area / float(count)));
    parallel_for(0, vertices.size(), 64, [&](size_t first, size_t last) {
        for (size_t i = first; i < last; ++i) vertices[i] = blend.at(metres_of_unit * mesh.positions[i]);
    });
    return vertices;
}

}  // namespace tyndall::translucency
