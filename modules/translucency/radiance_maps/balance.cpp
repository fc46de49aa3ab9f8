#include "radiance_maps/balance.h"

#include <cmath>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <numbers>

#include "core/parallel.h"
#include "geometry/surface_points.h"

namespace tyndall::translucency {
namespace {

constexpr int kLevels = 11;  ///< 2 to this power points
constexpr int kRounds = 6;

/// A kernel by the squared distance, from a table.
class KernelTable {
 public:
    KernelTable(const RadialKernel& kernel, float farthest) : per_metre_(float(kSteps) / farthest) {
        for (int i = 0; i <= kSteps; ++i) values_.push_back(kernel.at(float(i) / per_metre_));
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
    std::vector<glm::vec3> scales;
};

/// What leaves at a place of a unit of light a unit of area everywhere, not scaled there.
glm::vec3 found_at(const glm::vec3& place, const Points& points, const KernelTable& kernel) {
    glm::vec3 sum(0.0f);
    for (size_t j = 0; j < points.places.size(); ++j)
        sum += points.areas[j] * points.scales[j] * kernel.at(glm::distance(place, points.places[j]));
    return sum;
}

/// Scales between the points. (The sum at a place between them would not do: kernels are often narrower than pieces.)
class Blend {
 public:
    Blend(const Points& points, float spacing) : points_(points), spacing_(spacing) {
        for (size_t first = 0; first < points.places.size(); first += kTogether) {
            Bounds bounds;
            for (size_t i = first; i < first + kTogether; ++i) bounds.add(points.places[i]);
            balls_.emplace_back(bounds.centre(), bounds.radius());
        }
    }
    [[nodiscard]] glm::vec3 at(const glm::vec3& place) const {
        for (float reach = kReach * spacing_;; reach *= 4.0f) {
            glm::vec3 sum(0.0f);
            float weights = 0.0f;
            for (size_t ball = 0; ball < balls_.size(); ++ball)
                if (glm::distance(place, glm::vec3(balls_[ball])) < balls_[ball].w + reach)
                    add(place, ball * kTogether, reach, sum, weights);
            if (weights > 0.0f) return sum / weights;
        }
    }

 private:
    static constexpr size_t kTogether = 32;  ///< points that follow one another lie together
    static constexpr float kReach = 3.0f;    ///< spacings

    void add(const glm::vec3& place, size_t first, float reach, glm::vec3& sum, float& weights) const {
        for (size_t j = first; j < first + kTogether; ++j) {
            const glm::vec3 apart = points_.places[j] - place;
            const float d2 = glm::dot(apart, apart), r2 = d2 / (spacing_ * spacing_);
            const float inside = std::max(1.0f - d2 / (reach * reach), 0.0f);
            const float weight = inside * inside / (1e-3f + r2 * r2 * r2);
            sum += weight * points_.scales[j];
            weights += weight;
        }
    }

    const Points& points_;
    float spacing_;
    std::vector<glm::vec4> balls_;
};

}  // namespace

std::vector<glm::vec3> balance(const Mesh& mesh, const Optics& optics, Model model, float metres_of_unit) {
    std::vector<glm::vec3> scales(mesh.positions.size(), glm::vec3(1.0f));
    Points points;
    float area = 0.0f;
    for (const SurfacePoint& point : sample_surface(mesh, kLevels)) {
        points.places.push_back(metres_of_unit * point.position);
        points.areas.push_back(metres_of_unit * metres_of_unit * point.area);
        area += points.areas.back();
    }
    const size_t count = points.places.size();
    if (count == 0 || !(area > 0.0f)) return scales;
    points.scales.assign(count, glm::vec3(1.0f));
    const float piece = std::sqrt(area / (float(count) * std::numbers::pi_v<float>));
    const KernelTable kernel(RadialKernel(optics, model, Scaling::exact, piece),
                             1.01f * metres_of_unit * glm::length(mesh.bounds.size()));
    for (int round = 0; round < kRounds; ++round) {
        std::vector<glm::vec3> next(count);
        parallel_for(0, count, 64, [&](size_t first, size_t last) {
            for (size_t i = first; i < last; ++i)
                next[i] = glm::sqrt(points.scales[i] /
                                    glm::max(found_at(points.places[i], points, kernel), glm::vec3(1e-20f)));
        });
        points.scales = std::move(next);
    }
    const Blend blend(points, std::sqrt(area / float(count)));
    parallel_for(0, scales.size(), 64, [&](size_t first, size_t last) {
        for (size_t i = first; i < last; ++i) scales[i] = blend.at(metres_of_unit * mesh.positions[i]);
    });
    return scales;
}

}  // namespace tyndall::translucency
