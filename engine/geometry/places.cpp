#include "geometry/places.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace tyndall {

size_t number_places(const std::vector<glm::vec3>& positions, std::vector<std::uint32_t>& places) {
    std::vector<std::uint32_t> order(positions.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](std::uint32_t i) { return std::tuple(positions[i].x, positions[i].y, positions[i].z); };
    std::ranges::sort(order, {}, key);
    places.resize(positions.size());
    std::uint32_t count = 0;
    for (size_t i = 0; i < order.size(); ++i) {
        if (i > 0 && key(order[i]) != key(order[i - 1])) ++count;
        places[order[i]] = count;
    }
    return order.empty() ? 0 : count + 1;
}

}  // namespace tyndall
