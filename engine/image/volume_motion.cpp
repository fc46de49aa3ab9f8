#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "image/volume.h"

namespace tyndall {
namespace {

/// Linear between voxels' middles, whose places are whole numbers; 0 outside.
float value_at(const Volume& volume, const glm::vec3& place) {
    const glm::vec3 end = glm::vec3(volume.size) - 0.5f;
    if (!(place.x >= -0.5f && place.y >= -0.5f && place.z >= -0.5f && place.x <= end.x && place.y <= end.y &&
          place.z <= end.z))
        return 0.0f;
    const glm::vec3 whole = glm::floor(place), part = place - whole;
    const glm::ivec3 last = volume.size - 1;
    const glm::ivec3 low = glm::clamp(glm::ivec3(whole), glm::ivec3(0), last);
    const glm::ivec3 high = glm::clamp(glm::ivec3(whole) + 1, glm::ivec3(0), last);
    const auto row = [&](int y, int z) { return glm::mix(volume.at(low.x, y, z), volume.at(high.x, y, z), part.x); };
    return glm::mix(glm::mix(row(low.y, low.z), row(high.y, low.z), part.y),
                    glm::mix(row(low.y, high.z), row(high.y, high.z), part.y), part.z);
}

/// The mean on the way that a place's content comes and goes, `way` in voxels.
float mean_along(const Volume& volume, const glm::vec3& place, const glm::vec3& way) {
    const auto steps = static_cast<int>(std::clamp(2.0f * glm::length(way), 1.0f, float(kMostBlurSteps)));
    float sum = 0.0f;
    for (int i = 0; i < steps; ++i) {
        const float when = (static_cast<float>(i) + 0.5f) / static_cast<float>(steps) - 0.5f;
        sum += value_at(volume, place - way * when);
    }
    return sum / static_cast<float>(steps);
}

}  // namespace

Volume blurred_by_motion(const Volume& volume, std::span<const glm::vec3> velocity, float shutter_s) {
    Volume blurred = volume;
    size_t index = 0;
    for (int z = 0; z < volume.size.z; ++z)
        for (int y = 0; y < volume.size.y; ++y)
            for (int x = 0; x < volume.size.x; ++x, ++index) {
                const glm::vec3 way = velocity[index] * shutter_s / volume.voxel_m;
                const bool moves = glm::dot(way, way) > 0.0f && std::isfinite(glm::dot(way, way));
                if (moves) blurred.values[index] = mean_along(volume, glm::vec3(x, y, z), way);
            }
    return blurred;
}

}  // namespace tyndall
