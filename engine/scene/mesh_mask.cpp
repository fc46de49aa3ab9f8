#include "scene/mesh_mask.h"

#include <openvdb/openvdb.h>
#include <openvdb/tools/Dense.h>
#include <openvdb/tools/MeshToVolume.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "core/error.h"

namespace tyndall {
namespace {

constexpr float kSamePlace = 1e-5f;  ///< of the mesh's size

/// Numbers vertices so that those in the same place share one.
class Welder {
 public:
    explicit Welder(const Bounds& bounds) : low_(bounds.low), reach_(kSamePlace * std::max(bounds.radius(), 1e-20f)) {}

    uint32_t number(const glm::vec3& place) {
        const glm::ivec3 cell(glm::floor((place - low_) / (2.0f * reach_)));
        for (int i = 0; i < 27; ++i) {
            const glm::ivec3 at = cell + glm::ivec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
            const auto [first, last] = cells_.equal_range(key(at));
            for (auto known = first; known != last; ++known)
                if (glm::length(places_[known->second] - place) <= reach_) return known->second;
        }
        places_.push_back(place);
        const auto number = static_cast<uint32_t>(places_.size() - 1);
        cells_.emplace(key(cell), number);
        return number;
    }

 private:
    static uint64_t key(const glm::ivec3& cell) {
        return (uint64_t(uint32_t(cell.x)) * 0x9e3779b97f4a7c15u) ^ (uint64_t(uint32_t(cell.y)) << 32) ^
               (uint64_t(uint32_t(cell.z)) * 0xc2b2ae3d27d4eb4fu);
    }
    glm::vec3 low_;
    float reach_;
    std::vector<glm::vec3> places_;
    std::unordered_multimap<uint64_t, uint32_t> cells_;
};

openvdb::FloatGrid::Ptr signed_distance(const Mesh& mesh, const glm::vec3& low, float voxel) {
    std::vector<openvdb::Vec3s> points;
    points.reserve(mesh.positions.size());
    for (const glm::vec3& p : mesh.positions) points.emplace_back(p.x - low.x, p.y - low.y, p.z - low.z);
    std::vector<openvdb::Vec3I> triangles;
    triangles.reserve(mesh.triangle_count());
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        triangles.emplace_back(mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]);
    // voxels of OpenVDB have their centres at whole numbers
    const auto transform = openvdb::math::Transform::createLinearTransform(double(voxel));
    transform->postTranslate(openvdb::Vec3d(0.5 * double(voxel)));
    return openvdb::tools::meshToLevelSet<openvdb::FloatGrid>(*transform, points, triangles, 2.0f);
}

}  // namespace

size_t open_edges(const Mesh& mesh) {
    Welder welder(mesh.bounds);
    std::vector<uint32_t> numbers;
    numbers.reserve(mesh.positions.size());
    for (const glm::vec3& place : mesh.positions) numbers.push_back(welder.number(place));
    std::unordered_map<uint64_t, uint32_t> edges;
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const std::array corner{numbers[mesh.indices[i]], numbers[mesh.indices[i + 1]], numbers[mesh.indices[i + 2]]};
        if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) continue;  // no area
        for (size_t k = 0; k < 3; ++k) {
            const auto [a, b] = std::minmax(corner[k], corner[(k + 1) % 3]);
            ++edges[uint64_t(a) << 32 | b];
        }
    }
    return static_cast<size_t>(std::ranges::count_if(edges, [](const auto& edge) { return edge.second % 2 != 0; }));
}

Volume voxelised(const Mesh& mesh, int resolution, const std::string& source) {
    const auto fail = [&](std::string message) {
        throw Error(Diagnostic{{source}, std::move(message), "a closed mesh, which has an inside", {}});
    };
    const glm::vec3 size = mesh.bounds.size();
    const float longest = std::max({size.x, size.y, size.z});
    if (mesh.triangle_count() == 0 || !(longest > 0.0f)) fail("the mesh has no triangles, or no extent");
    if (const size_t open = open_edges(mesh)) fail("the mesh is not closed: " + std::to_string(open) + " open edges");
    Volume volume;
    const float voxel = longest / float(resolution);
    volume.voxel_m = glm::vec3(voxel);
    volume.size = glm::ivec3(glm::ceil(size / voxel - 1e-3f)) + 2;  // the surface's blur reaches outside
    volume.low_m = mesh.bounds.centre() - 0.5f * voxel * glm::vec3(volume.size);
    const openvdb::FloatGrid::Ptr distance = signed_distance(mesh, volume.low_m, voxel);
    volume.values.resize(size_t(volume.size.x) * size_t(volume.size.y) * size_t(volume.size.z));
    openvdb::tools::Dense<float, openvdb::tools::LayoutXYZ> dense(
        openvdb::CoordBBox(openvdb::Coord(0), openvdb::Coord(volume.size.x - 1, volume.size.y - 1, volume.size.z - 1)),
        volume.values.data());
    openvdb::tools::copyToDense(*distance, dense);
    for (float& value : volume.values) value = glm::clamp(0.5f - value / voxel, 0.0f, 1.0f);
    return volume;
}

}  // namespace tyndall
