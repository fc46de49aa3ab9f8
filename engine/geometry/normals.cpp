#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <span>

#include "geometry/mesh.h"
#include "geometry/places.h"
#include "geometry/vertex_split.h"

namespace tyndall {
namespace {

/// Faces around a point beyond which creases are not looked for: the search is quadratic.
constexpr size_t kMostBlended = 2000;

glm::vec3 unit_or_zero(glm::vec3 v) {
    const float length = glm::length(v);
    return length > 0 && std::isfinite(length) ? v / length : glm::vec3(0.0f);
}

/// The angle of a triangle at `corner`.
float angle_at(const Mesh& mesh, size_t corner) {
    const size_t face = corner - corner % 3;
    const auto position = [&](size_t i) { return mesh.positions[mesh.indices[face + i % 3]]; };
    const glm::vec3 a = unit_or_zero(position(corner + 1) - position(corner));
    const glm::vec3 b = unit_or_zero(position(corner + 2) - position(corner));
    return std::acos(std::clamp(glm::dot(a, b), -1.0f, 1.0f));
}

/// The corners around each place: corners[starts[p]] .. corners[starts[p + 1]].
struct CornersOfPlaces {
    std::vector<std::uint32_t> starts, corners;

    CornersOfPlaces(const Mesh& mesh, const std::vector<std::uint32_t>& places, size_t place_count)
        : starts(place_count + 1), corners(mesh.indices.size()) {
        for (const std::uint32_t index : mesh.indices) ++starts[places[index] + 1];
        std::partial_sum(starts.begin(), starts.end(), starts.begin());
        std::vector<std::uint32_t> next(starts.begin(), starts.end() - 1);
        for (std::uint32_t c = 0; c < corners.size(); ++c) corners[next[places[mesh.indices[c]]]++] = c;
    }
    [[nodiscard]] std::span<const std::uint32_t> at(std::uint32_t place) const {
        return std::span(corners).subspan(starts[place], starts[place + 1] - starts[place]);
    }
};

}  // namespace

void compute_normals(Mesh& mesh, float crease) {
    const size_t corner_count = mesh.indices.size();
    std::vector<std::uint32_t> places;
    const size_t place_count = number_places(mesh.positions, places);
    const CornersOfPlaces around(mesh, places, place_count);

    std::vector<glm::vec3> faces(corner_count / 3);
    std::vector<glm::vec3> weighted(corner_count);  // the face's normal times its angle at the corner
    for (size_t c = 0; c < corner_count; ++c) {
        if (c % 3 == 0) {
            const auto p = [&](size_t i) { return mesh.positions[mesh.indices[c + i]]; };
            faces[c / 3] = unit_or_zero(glm::cross(p(1) - p(0), p(2) - p(0)));
        }
        weighted[c] = faces[c / 3] * angle_at(mesh, c);
    }

    const float least_cosine = crease >= std::numbers::pi_v<float> ? -2.0f : std::cos(crease);
    VertexSplitter<glm::vec3> split(mesh.positions.size());
    for (size_t c = 0; c < corner_count; ++c) {
        const auto corners = around.at(places[mesh.indices[c]]);
        const bool degenerate = faces[c / 3] == glm::vec3(0.0f);  // it has no side of a crease to be on
        const bool all = least_cosine < -1 || degenerate || corners.size() > kMostBlended;
        glm::vec3 sum(0.0f);  // in the same order for every corner of a smooth place: equal to the last bit
        for (const std::uint32_t other : corners)
            if (all || glm::dot(faces[c / 3], faces[other / 3]) >= least_cosine) sum += weighted[other];
        const glm::vec3 normal = unit_or_zero(sum);
        mesh.indices[c] = split(mesh.indices[c], normal == glm::vec3(0.0f) ? glm::vec3(0, 1, 0) : normal);
    }
    gather_vertices(mesh, split.sources());
    mesh.normals = split.variants();
}

}  // namespace tyndall
