#include "texture_space/charts.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <unordered_map>

namespace tyndall::skin {
namespace {

/// A number for each vertex, shared by those for which `same` holds. `along` sorts them so that equals are less than
/// `window` apart.
template <class Same>
std::vector<uint32_t> weld(const std::vector<float>& along, float window, const Same& same) {
    std::vector<uint32_t> order(along.size()), number(along.size());
    std::iota(order.begin(), order.end(), 0u);
    std::iota(number.begin(), number.end(), 0u);
    std::ranges::sort(order, {}, [&](uint32_t vertex) { return std::pair(along[vertex], vertex); });
    for (size_t i = 0; i < order.size(); ++i) {
        for (size_t j = i; j-- > 0 && along[order[i]] - along[order[j]] <= window;) {
            if (!same(order[i], order[j])) continue;
            number[order[i]] = number[order[j]];
            break;
        }
    }
    return number;
}

std::vector<uint32_t> weld_places(const Mesh& mesh) {
    const float near = 1e-5f * glm::distance(mesh.bounds.low, mesh.bounds.high);
    // no plane of a usual model holds still along it
    const glm::vec3 direction = glm::normalize(glm::vec3(0.577f, 0.619f, 0.531f));
    std::vector<float> along(mesh.positions.size());
    std::ranges::transform(mesh.positions, along.begin(), [&](const glm::vec3& p) { return glm::dot(p, direction); });
    return weld(along, near,
                [&](uint32_t a, uint32_t b) { return glm::distance(mesh.positions[a], mesh.positions[b]) <= near; });
}

/// Of vertices in the same place, those with the same UVs.
std::vector<uint32_t> weld_points(const Mesh& mesh, const std::vector<uint32_t>& places) {
    constexpr float kNear = 1e-6f;
    std::vector<uint32_t> points(places.size());
    std::unordered_map<uint32_t, std::vector<uint32_t>> of_place;
    for (uint32_t vertex = 0; vertex < uint32_t(places.size()); ++vertex) {
        std::vector<uint32_t>& others = of_place[places[vertex]];
        const auto found = std::ranges::find_if(
            others, [&](uint32_t other) { return glm::distance(mesh.uv0[other], mesh.uv0[vertex]) <= kNear; });
        points[vertex] = found == others.end() ? vertex : *found;
        if (found == others.end()) others.push_back(vertex);
    }
    return points;
}

/// Numbers for what hangs together.
class Groups {
 public:
    explicit Groups(size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0u); }
    uint32_t find(uint32_t i) {
        while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
        return i;
    }
    void join(uint32_t a, uint32_t b) { parents_[find(a)] = find(b); }

 private:
    std::vector<uint32_t> parents_;
};

/// Edges of the triangles without direction: a corner of the mesh for each triangle that has it.
std::map<std::pair<uint32_t, uint32_t>, std::vector<uint32_t>> edges_of(const Mesh& mesh,
                                                                        const std::vector<uint32_t>& numbers) {
    std::map<std::pair<uint32_t, uint32_t>, std::vector<uint32_t>> edges;
    for (uint32_t corner = 0; corner < uint32_t(mesh.indices.size()); ++corner) {
        const uint32_t next = corner % 3 == 2 ? corner - 2 : corner + 1;
        const uint32_t a = numbers[mesh.indices[corner]], b = numbers[mesh.indices[next]];
        if (a != b) edges[std::minmax(a, b)].push_back(corner);
    }
    return edges;
}

void find_twins(const std::vector<uint32_t>& places, std::vector<ChartBorder>& borders) {
    std::map<std::pair<uint32_t, uint32_t>, std::vector<int>> at_place;
    for (int i = 0; i < int(borders.size()); ++i) {
        const uint32_t a = places[borders[size_t(i)].vertices[0]], b = places[borders[size_t(i)].vertices[1]];
        std::vector<int>& there = at_place[std::minmax(a, b)];
        // the other side goes along it the other way
        const auto found = std::ranges::find_if(there, [&](int other) {
            const ChartBorder& border = borders[size_t(other)];
            return border.twin < 0 && places[border.vertices[0]] == b && places[border.vertices[1]] == a;
        });
        if (found != there.end()) {
            borders[size_t(i)].twin = *found;
            borders[size_t(*found)].twin = i;
        } else {
            there.push_back(i);
        }
    }
}

}  // namespace

Charts find_charts(const Mesh& mesh) {
    Charts charts;
    const std::vector<uint32_t> places = weld_places(mesh);
    charts.points = weld_points(mesh, places);
    const auto edges = edges_of(mesh, charts.points);
    Groups groups(mesh.triangle_count());
    for (const auto& [edge, corners] : edges)
        for (size_t i = 1; i < corners.size(); ++i) groups.join(corners[i] / 3, corners[0] / 3);
    std::unordered_map<uint32_t, uint32_t> numbers;
    for (uint32_t triangle = 0; triangle < uint32_t(mesh.triangle_count()); ++triangle)
        charts.of_triangle.push_back(
            numbers.try_emplace(groups.find(triangle), uint32_t(numbers.size()) + 1).first->second);
    charts.count = uint32_t(numbers.size());
    for (const auto& [edge, corners] : edges) {
        if (corners.size() != 1) continue;
        const uint32_t first = corners[0] - corners[0] % 3, side = corners[0] % 3;
        charts.borders.push_back({{mesh.indices[corners[0]], mesh.indices[first + (side + 1) % 3]},
                                  mesh.indices[first + (side + 2) % 3],
                                  charts.of_triangle[corners[0] / 3]});
    }
    find_twins(places, charts.borders);
    return charts;
}

}  // namespace tyndall::skin
