#include <algorithm>
#include <cmath>

#include "scene/density.h"

namespace tyndall {
namespace {

// Evaluation rounds; a bound is this much above what exact arithmetic gives.
constexpr float kSlack = 1.0f + 1e-5f;

float finite(float value) {
    return value < std::numeric_limits<float>::max() ? std::max(value, 0.0f) : 0.0f;
}

/// Half the extent of a local box along the axes of `map`'s target.
glm::vec3 mapped_half(const glm::mat4& map, const Bounds& local) {
    const glm::vec3 half = 0.5f * local.size();
    return glm::abs(glm::vec3(map[0])) * half.x + glm::abs(glm::vec3(map[1])) * half.y +
           glm::abs(glm::vec3(map[2])) * half.z;
}

}  // namespace

/// Greatest values of ever larger blocks of voxels, each level half the size of the one before: a large box looks at
/// few of them. Level 0 is the volume itself.
struct GridEvaluator::MaximaOfBlocks {
    std::vector<Volume> levels;

    explicit MaximaOfBlocks(const Volume& volume) {
        const Volume* finer = &volume;
        levels.reserve(32);
        while (std::max({finer->size.x, finer->size.y, finer->size.z}) > 1) {
            levels.push_back(halved(*finer));
            finer = &levels.back();
        }
    }

    static Volume halved(const Volume& finer) {
        Volume coarser;
        coarser.size = (finer.size + 1) / 2;
        coarser.values.assign(size_t(coarser.size.x) * size_t(coarser.size.y) * size_t(coarser.size.z), 0.0f);
        size_t index = 0;
        for (int z = 0; z < finer.size.z; ++z)
            for (int y = 0; y < finer.size.y; ++y)
                for (int x = 0; x < finer.size.x; ++x, ++index) {
                    const size_t row = size_t(z / 2) * size_t(coarser.size.y) + size_t(y / 2);
                    float& block = coarser.values[row * size_t(coarser.size.x) + size_t(x / 2)];
                    block = std::max(block, finer.values[index]);
                }
        return coarser;
    }

    /// Greatest voxel between `low` and `high`, both inside the volume.
    [[nodiscard]] float greatest(const Volume& volume, glm::ivec3 low, glm::ivec3 high) const {
        constexpr int kMost = 6;  // blocks along an axis
        size_t level = 0;
        for (; level < levels.size(); ++level, low /= 2, high /= 2) {
            const glm::ivec3 count = high - low + 1;
            if (std::max({count.x, count.y, count.z}) <= kMost) break;
        }
        const Volume& blocks = level == 0 ? volume : levels[level - 1];
        float greatest = 0.0f;
        for (int z = low.z; z <= high.z; ++z)
            for (int y = low.y; y <= high.y; ++y)
                for (int x = low.x; x <= high.x; ++x) greatest = std::max(greatest, blocks.at(x, y, z));
        return greatest;
    }
};

GridEvaluator::GridEvaluator(const GridDensity& grid) : grid_(grid) {
    if (!grid.volume || grid.volume->volume.values.empty()) return;
    const Volume& volume = grid.volume->volume;
    const glm::vec3 size(volume.size);
    for (int column = 0; column < 4; ++column)
        map_[column] = glm::vec4(glm::vec3(grid.to_volume[column]) * size, grid.to_volume[column].w);
    map_[3] -= glm::vec4(0.5f, 0.5f, 0.5f, 0.0f);
    for (int column = 0; column < 4; ++column)
        if (!(glm::dot(map_[column], map_[column]) < std::numeric_limits<float>::max())) return;
    maxima_ = std::make_shared<const MaximaOfBlocks>(volume);
}

float GridEvaluator::at(const glm::vec3& local) const {
    if (!maxima_) return 0.0f;
    const Volume& volume = grid_.volume->volume;
    const glm::vec3 place = glm::vec3(map_ * glm::vec4(local, 1.0f));
    const glm::vec3 end = glm::vec3(volume.size) - 0.5f;
    // written so that what is not a number is outside
    if (!(place.x >= -0.5f && place.y >= -0.5f && place.z >= -0.5f && place.x <= end.x && place.y <= end.y &&
          place.z <= end.z))
        return 0.0f;
    const glm::vec3 whole = glm::floor(place);
    const glm::vec3 part = place - whole;
    const glm::ivec3 last = volume.size - 1;
    const glm::ivec3 low = glm::clamp(glm::ivec3(whole), glm::ivec3(0), last);
    const glm::ivec3 high = glm::clamp(glm::ivec3(whole) + 1, glm::ivec3(0), last);
    const auto row = [&](int y, int z) { return glm::mix(volume.at(low.x, y, z), volume.at(high.x, y, z), part.x); };
    const float value = glm::mix(glm::mix(row(low.y, low.z), row(high.y, low.z), part.y),
                                 glm::mix(row(low.y, high.z), row(high.y, high.z), part.y), part.z);
    return finite(value * grid_.scale);
}

float GridEvaluator::upper_bound(const Bounds& local) const {
    if (!maxima_ || local.empty()) return 0.0f;
    const Volume& volume = grid_.volume->volume;
    const glm::vec3 centre = glm::vec3(map_ * glm::vec4(local.centre(), 1.0f));
    const glm::vec3 reach = glm::max(glm::abs(local.low), glm::abs(local.high));
    const Bounds about{-reach, reach};
    const glm::vec3 half =
        mapped_half(map_, local) + 0.01f + 1e-6f * (mapped_half(map_, about) + glm::vec3(volume.size));
    const glm::vec3 last(volume.size - 1);
    const glm::vec3 low = centre - half, high = centre + half;
    if (glm::any(glm::lessThan(high, glm::vec3(-0.5f))) || glm::any(glm::greaterThan(low, last + 0.5f))) return 0.0f;
    const glm::ivec3 first(glm::clamp(glm::floor(low), glm::vec3(0.0f), last));
    const glm::ivec3 past(glm::clamp(glm::floor(high) + 1.0f, glm::vec3(0.0f), last));
    return finite(kSlack * maxima_->greatest(volume, first, past) * grid_.scale);
}

}  // namespace tyndall
