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

ChunkSet without(const ChunkSet& a, const ChunkSet& b) {
    ChunkSet rest(a.size());
    for (size_t i = 0; i < a.size(); ++i) rest[i] = a[i] != 0 && b[i] == 0 ? 1 : 0;
    return rest;
}

bool holds(const ChunkSet& whole, const ChunkSet& part) {
    if (whole.size() != part.size()) return false;
    for (size_t i = 0; i < part.size(); ++i)
        if (part[i] != 0 && whole[i] == 0) return false;
    return true;
}

std::vector<size_t> chunk_begins(const Atlas& atlas) {
    constexpr int kElsewhere = 16;  // texels
    std::vector<size_t> begins;
    for (size_t i = 0; i < atlas.texels.size(); ++i) {
        const AtlasTexel& texel = atlas.texels[i];
        if (!begins.empty()) {
            const AtlasTexel& first = atlas.texels[begins.back()];
            const glm::ivec2 way = glm::abs(texel.at - first.at);
            const bool near = texel.chart == first.chart && std::max(way.x, way.y) < kElsewhere;
            if (near && i - begins.back() < kChunkTexels) continue;
        }
        begins.push_back(i);
    }
    begins.push_back(atlas.texels.size());
    return begins;
}

AtlasChunks::AtlasChunks(const Atlas& atlas) {
    const std::vector<AtlasTexel>& texels = atlas.texels;
    const std::vector<size_t> begins = chunk_begins(atlas);
    for (size_t number = 0; number + 1 < begins.size(); ++number) {
        const size_t first = begins[number], end = begins[number + 1];
        Chunk chunk;
        glm::vec3 low(1e30f), high(-1e30f);
        for (size_t i = first; i < end; ++i) {
            low = glm::min(low, texels[i].position);
            high = glm::max(high, texels[i].position);
        }
        chunk.centre = 0.5f * (low + high);
        for (size_t i = first; i < end; ++i)
            chunk.radius = std::max(chunk.radius, glm::distance(chunk.centre, texels[i].position));
        chunk.normals = cone_of(atlas, first, end, &AtlasTexel::normal);
        chunk.faces = cone_of(atlas, first, end, &AtlasTexel::face);
        chunks_.push_back(chunk);
    }
}

AtlasChunks::Cone AtlasChunks::cone_of(const Atlas& atlas, size_t first, size_t end, glm::vec3 AtlasTexel::*direction) {
    Cone cone;
    for (size_t i = first; i < end; ++i) cone.axis += atlas.texels[i].*direction;
    cone.axis /= std::max(glm::length(cone.axis), 1e-12f);
    for (size_t i = first; i < end; ++i) {
        const float cosine = glm::clamp(glm::dot(cone.axis, atlas.texels[i].*direction), -1.0f, 1.0f);
        cone.angle = std::max(cone.angle, std::acos(cosine));
    }
    return cone;
}

ChunkSet AtlasChunks::lit_from(const glm::vec4& place) const {
    return facing(place, &Chunk::normals);
}

ChunkSet AtlasChunks::seen_from(const glm::vec4& place) const {
    return facing(place, &Chunk::faces);
}

ChunkSet AtlasChunks::facing(const glm::vec4& place, Cone Chunk::*cone) const {
    constexpr float kPi = std::numbers::pi_v<float>, kRounding = 1e-3f;
    ChunkSet set(size());
    for (size_t i = 0; i < size(); ++i) {
        const Chunk& chunk = chunks_[i];
        const glm::vec3 way = glm::vec3(place) - place.w * chunk.centre;
        const float distance = std::max(glm::length(way), 1e-20f);
        const float ball = std::asin(std::min(place.w * chunk.radius / distance, 1.0f));
        const float most = 0.5f * kPi + (chunk.*cone).angle + ball + kRounding;
        set[i] = most >= kPi || glm::dot((chunk.*cone).axis, way) >= distance * std::cos(most) ? 1 : 0;
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
