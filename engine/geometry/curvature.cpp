#include "geometry/curvature.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/error.h"
#include "geometry/places.h"

namespace tyndall {
namespace {

/// Beyond these the smoothing stops short: very fine meshes.
constexpr int kMostRounds = 400;

/// Adds up over the edges around each place.
class EdgeMeans {
 public:
    EdgeMeans(const Mesh& mesh, const std::vector<std::uint32_t>& places, size_t count)
        : mesh_(mesh), places_(places), sums_(count), counts_(count) {}

    /// The mean of `value(vertex, its neighbour)` over the edges of each place; `rest` where there are none.
    template <class Value>
    std::vector<float> of(const Value& value, const std::vector<float>& rest) {
        std::ranges::fill(sums_, 0.0f);
        std::ranges::fill(counts_, 0);
        for (size_t c = 0; c < mesh_.indices.size(); ++c) {
            const std::uint32_t a = mesh_.indices[c], b = mesh_.indices[c - c % 3 + (c + 1) % 3];
            add(a, b, value);
            add(b, a, value);
        }
        std::vector<float> means(rest);
        for (size_t p = 0; p < means.size(); ++p)
            if (counts_[p] > 0) means[p] = sums_[p] / float(counts_[p]);
        return means;
    }

 private:
    template <class Value>
    void add(std::uint32_t from, std::uint32_t to, const Value& value) {
        if (places_[from] == places_[to]) return;
        sums_[places_[from]] += value(from, to);
        ++counts_[places_[from]];
    }

    const Mesh& mesh_;
    const std::vector<std::uint32_t>& places_;
    std::vector<float> sums_;
    std::vector<int> counts_;
};

float mean_square_edge(const Mesh& mesh) {
    double sum = 0.0;
    for (size_t c = 0; c < mesh.indices.size(); ++c) {
        const glm::vec3 d = mesh.positions[mesh.indices[c]] - mesh.positions[mesh.indices[c - c % 3 + (c + 1) % 3]];
        sum += double(glm::dot(d, d));
    }
    return float(sum / double(std::max<size_t>(mesh.indices.size(), 1)));
}

}  // namespace

void compute_curvatures(Mesh& mesh, float smoothing) {
    if (mesh.normals.size() != mesh.positions.size()) throw Error("curvatures need normals");
    std::vector<std::uint32_t> places;
    const size_t count = number_places(mesh.positions, places);
    EdgeMeans means(mesh, places, count);
    std::vector<float> curvature = means.of(
        [&](std::uint32_t from, std::uint32_t to) {
            const glm::vec3 along = mesh.positions[to] - mesh.positions[from];
            return glm::dot(along, mesh.normals[to] - mesh.normals[from]) / glm::dot(along, along);
        },
        std::vector<float>(count, 0.0f));
    // half of a place's value goes to its neighbours: a quarter of the squared edge of variance in each direction
    const float a_round = 0.25f * mean_square_edge(mesh);
    const int rounds =
        a_round > 0.0f ? int(std::min(std::round(smoothing * smoothing / a_round), float(kMostRounds))) : 0;
    for (int i = 0; i < rounds; ++i)
        curvature = means.of([&](std::uint32_t from,
                                 std::uint32_t to) { return 0.5f * (curvature[places[from]] + curvature[places[to]]); },
                             curvature);
    mesh.curvatures.resize(mesh.positions.size());
    for (size_t i = 0; i < places.size(); ++i) mesh.curvatures[i] = curvature[places[i]];
}

}  // namespace tyndall
