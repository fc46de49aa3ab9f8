#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "image/compare.h"

namespace tyndall {

Image heat_map(const Image& map) {
    constexpr glm::vec3 kRamp[] = {{0, 0, 4}, {87, 16, 110}, {188, 55, 84}, {249, 142, 9}, {252, 255, 164}};
    Image out(map.width, map.height, 3, Image::Type::u8);
    for (size_t i = 0; i < map.floats().size(); ++i) {
        const float v = map.floats()[i * static_cast<size_t>(map.channels)];
        const float at = 4 * (v > 0 ? std::min(v, 1.0f) : 0.0f);
        const auto low = std::min(static_cast<size_t>(at), size_t{3});
        const glm::vec3 colour = glm::mix(kRamp[low], kRamp[low + 1], at - static_cast<float>(low));
        for (size_t c = 0; c < 3; ++c)
            out.bytes()[3 * i + c] = static_cast<std::uint8_t>(std::lround(colour[static_cast<int>(c)]));
    }
    return out;
}

}  // namespace tyndall
