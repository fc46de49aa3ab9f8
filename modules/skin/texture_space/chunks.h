#pragma once
/// Texels of an atlas in groups that lie together: which of them have to be looked at.

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "texture_space/atlas.h"

namespace tyndall::skin {

/// The most texels in a group, one after the other in the atlas' list; a shader's group.
inline constexpr int kChunkTexels = 64;
/// The first texels of the groups, and how many texels there are: a group ends early where the next texel is elsewhere.
[[nodiscard]] std::vector<size_t> chunk_begins(const Atlas& atlas);

/// Which chunks of an atlas, one byte each: 0 = not.
using ChunkSet = std::vector<uint8_t>;
[[nodiscard]] ChunkSet operator&(const ChunkSet& a, const ChunkSet& b);
[[nodiscard]] ChunkSet without(const ChunkSet& a, const ChunkSet& b);
/// Whether all of `part` is in `whole`.
[[nodiscard]] bool holds(const ChunkSet& whole, const ChunkSet& part);

class AtlasChunks {
 public:
    explicit AtlasChunks(const Atlas& atlas);

    [[nodiscard]] size_t size() const { return chunks_.size(); }
    [[nodiscard]] ChunkSet all() const { return ChunkSet(size(), 1); }
    /// Those with a vertices' normal that faces a place, or with w = 0 a direction; in the mesh's space.
    [[nodiscard]] ChunkSet lit_from(const glm::vec4& place) const;
    /// Those with a triangle that does.
    [[nodiscard]] ChunkSet seen_from(const glm::vec4& place) const;
    /// Takes out those whose ball (in the mesh's space) `keeps` does not want.
    void remove(ChunkSet& set, const std::function<bool(const glm::vec3& centre, float radius)>& keeps) const;
    /// With all that is within `reach` of them, in the mesh's space; slow when `reach` is another than last time.
    [[nodiscard]] ChunkSet grown(const ChunkSet& set, float reach);

 private:
    /// Holds directions.
    struct Cone {
        glm::vec3 axis{0.0f};
        float angle = 0.0f;  ///< half of its opening, radians
    };
    struct Chunk {
        glm::vec3 centre{0.0f};
        float radius = 0.0f;
        Cone normals, faces;
    };
    static Cone cone_of(const Atlas& atlas, size_t first, size_t end, glm::vec3 AtlasTexel::*direction);
    [[nodiscard]] ChunkSet facing(const glm::vec4& place, Cone Chunk::*cone) const;
    void find_neighbours(float reach);

    std::vector<Chunk> chunks_;
    float reach_ = -1.0f;  ///< of the neighbours
    std::vector<uint32_t> neighbours_, begins_;
};

}  // namespace tyndall::skin
