#pragma once
// Giving the corners of triangles vertices of their own where an attribute differs; for the sources of this floor.

#include <cstdint>
#include <vector>

#include "geometry/mesh.h"

namespace tyndall {

/// Numbers the different (vertex, variant) pairs in the order in which they are first asked for.
template <class Variant>
class VertexSplitter {
 public:
    explicit VertexSplitter(size_t vertex_count) : first_(vertex_count, kNone) {}

    /// The new vertex of that pair.
    std::uint32_t operator()(std::uint32_t vertex, const Variant& variant) {
        std::uint32_t* link = &first_[vertex];
        while (*link != kNone) {
            if (variants_[*link] == variant) return *link;
            link = &next_[*link];
        }
        const auto made = static_cast<std::uint32_t>(sources_.size());
        *link = made;  // before the vectors may move
        sources_.push_back(vertex);
        variants_.push_back(variant);
        next_.push_back(kNone);
        return made;
    }

    /// For each new vertex the one that it was made from, and its variant.
    [[nodiscard]] const std::vector<std::uint32_t>& sources() const { return sources_; }
    [[nodiscard]] const std::vector<Variant>& variants() const { return variants_; }

 private:
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};
    std::vector<std::uint32_t> first_, next_, sources_;
    std::vector<Variant> variants_;
};

/// values[sources[0]], values[sources[1]], ...; empty stays empty.
template <class T>
std::vector<T> gathered(const std::vector<T>& values, const std::vector<std::uint32_t>& sources) {
    std::vector<T> out;
    if (values.empty()) return out;
    out.reserve(sources.size());
    for (const std::uint32_t source : sources) out.push_back(values[source]);
    return out;
}

/// Replaces every attribute by its values at `sources`; the indices are the caller's.
inline void gather_vertices(Mesh& mesh, const std::vector<std::uint32_t>& sources) {
    mesh.positions = gathered(mesh.positions, sources);
    mesh.normals = gathered(mesh.normals, sources);
    mesh.tangents = gathered(mesh.tangents, sources);
    mesh.uv0 = gathered(mesh.uv0, sources);
    mesh.uv1 = gathered(mesh.uv1, sources);
    mesh.curvatures = gathered(mesh.curvatures, sources);
}

}  // namespace tyndall
