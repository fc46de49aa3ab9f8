#include "texture_space/chunks.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <tuple>

namespace tyndall::skin {

ChunkSet operator&(const ChunkSet& a, const ChunkSet& b) {
    ChunkSet both(a.size());
    for (size_t i = 0; i < a.size(); ++i) both[i] = a[i] & b[i];
    return both;
}

bool holds(const ChunkSet& whole, const ChunkSet& part) {
    if (whole.size() != part.size()) return false;
    for (size_t i = 0; i < part.size(); ++i)
        if (part[i] != 0 && whole[i] == 0) return false;
    return true;
}

AtlasChunks::AtlasChunks(const Atlas& atlas) {
    const std::vector<AtlasTexel>& texels = atlas.texels;
    for (size_t first = 0; first < texels.size(); first += kChunkTexels) {
        const size_t end = std::min(first + kChunkTexels, texels.size());
        Chunk chunk;
        glm::vec3 low(1e30f), high(-1e30f);
        for (size_t i = first; i < end; ++i) {
            low = glm::min(low, texels[i].position);
            high = glm::max(high, texels[i].position);
            chunk.axis += texels[i].normal;
        }
        chunk.centre = 0.5f * (low + high);
        chunk.axis /= std::max(glm::length(chunk.axis), 1e-12f);
        for (size_t i = first; i < end; ++i) {
            chunk.radius = std::max(chunk.radius, glm::distance(chunk.centre, texels[i].position));
            const float cosine = glm::clamp(glm::dot(chunk.axis, texels[i].normal), -1.0f, 1.0f);
            chunk.angle = std::max(chunk.angle, std::acos(cosine));
        }
        chunks_.push_back(chunk);
    }
}

ChunkSet AtlasChunks::facing(const glm::vec4& place, float widened) const {
    ChunkSet set(size());
    for (size_t i = 0; i < size(); ++i) {
        const Chunk& chunk = chunks_[i];
        const glm::vec3 way = glm::vec3(place) - place.w * chunk.centre;
        const float distance = glm::length(way);
        const float ball = std::asin(std::min(place.w * chunk.radius / std::max(distance, 1e-20f), 1.0f));
        const float least = 0.5f * std::numbers::pi_v<float> + chunk.angle + ball + widened;
        const float cosine = glm::dot(chunk.axis, way) / std::max(distance, 1e-20f);
        set[i] = least >= std::numbers::pi_v<float> || cosine >= std::cos(least) ? 1 : 0;
    }
    return set;
}

void AtlasChunks::remove(ChunkSet& set, const std::function<bool(const glm::vec3& centre, float radius)>& keeps) const {
    for (size_t i = 0; i < size(); ++i)
        if (set[i] != 0 && !keeps(chunks_[i].centre, chunks_[i].radius)) set[i] = 0;
}

ChunkSet AtlasChunks::grown(const ChunkSet& set, float reach) {
    // in steps, so that what turns and is scaled a little keeps its neighbours
    const float step = std::exp2(std::ceil(4.0f * std::log2(std::max(reach, 1e-20f))) / 4.0f);
    if (step != reach_) find_neighbours(step);
    ChunkSet result = set;
    for (size_t i = 0; i < size(); ++i) {
        if (set[i] == 0) continue;
        for (uint32_t n = begins_[i]; n < begins_[i + 1]; ++n) result[neighbours_[n]] = 1;
    }
    return result;
}

void AtlasChunks::find_neighbours(float reach) {
    reach_ = reach;
    float widest = 0.0f;
    for (const Chunk& chunk : chunks_) widest = std::max(widest, chunk.radius);
    const float cell = 2.0f * widest + reach;
    using Cell = std::tuple<int, int, int>;
    const auto cell_of = [&](const glm::vec3& p) {
        const glm::vec3 at = glm::floor(p / cell);
        return Cell(int(at.x), int(at.y), int(at.z));
    };
    std::map<Cell, std::vector<uint32_t>> cells;
    for (uint32_t i = 0; i < uint32_t(size()); ++i) cells[cell_of(chunks_[i].centre)].push_back(i);
    neighbours_.clear();
    begins_.assign(1, 0);
    for (const Chunk& chunk : chunks_) {
        const auto [x, y, z] = cell_of(chunk.centre);
        for (int near = 0; near < 27; ++near) {
            const auto found = cells.find({x + near % 3 - 1, y + near / 3 % 3 - 1, z + near / 9 - 1});
            if (found == cells.end()) continue;
            for (const uint32_t other : found->second)
                if (glm::distance(chunk.centre, chunks_[other].centre) <= chunk.radius + chunks_[other].radius + reach)
                    neighbours_.push_back(other);
        }
        begins_.push_back(uint32_t(neighbours_.size()));
    }
}

}  // namespace tyndall::skin
