#pragma once
/// A mesh as the technique points sees it: points in a tree, who gathers from which groups, and how vertices blend
/// points.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "geometry/surface_points.h"

namespace tyndall::translucency {

/// Lengths are of the mesh's own space.
///
/// The points are the leaves of a binary tree; node n of level l holds those from n 2^l on and has the number
/// first(l) + n. Points gather in clusters of kCluster that lie together: a cluster's list names the nodes that
/// together hold every point once, each far enough from the whole cluster to count as one (Barnes & Hut 1986; for
/// translucent solids Jensen & Buhler 2002).
struct PointCloud {
    static constexpr uint32_t kCluster = 64;
    static constexpr uint32_t kNeighbours = 4;
    static constexpr int kSightRays = 16;       ///< of a point
    static constexpr uint32_t kSightGroup = 8;  ///< points that see together

    /// A vertex of the mesh that is drawn: the mesh's own, cut where its triangles are large for the points.
    struct Vertex {
        glm::vec3 position{0.0f};
        std::array<uint16_t, kNeighbours> points{};
        std::array<uint8_t, kNeighbours> weights{};  ///< sum to about 255
    };

    int levels = 0;
    std::vector<SurfacePoint> points;
    std::vector<uint32_t> lists;        ///< nodes' numbers of all clusters, one after the other, groups before points
    std::vector<uint32_t> list_begins;  ///< clusters + 1
    std::vector<uint32_t> sights;  ///< of all groups one after the other: groups that their rays meet (look_around)
    std::vector<uint32_t> sight_begins;  ///< groups + 1
    std::vector<float> depths;           ///< of the body below each group, the mean over rays: InwardRays
    std::vector<Vertex> group_blends;    ///< groups that stand for each point
    std::vector<Vertex> vertices;
    std::vector<uint32_t> indices;
    float spacing = 0.0f;  ///< side of a square of a piece's area
    float radius = 0.0f;   ///< 3 times the volume over the surface; 0 = the mesh encloses nothing

    /// Number of a level's first node.
    [[nodiscard]] uint32_t first(int level) const {
        const uint32_t count = uint32_t(1) << uint32_t(levels);
        return 2 * count - (2 * count >> uint32_t(level));
    }
};

/// Empty when the mesh has no area. `levels` 6..16; `opening`: radius over distance up to which a node counts as one.
/// Without `interreflection` the points have no sights.
[[nodiscard]] PointCloud make_point_cloud(const Mesh& mesh, int levels, float opening, bool interreflection);

/// From each point of a cloud kSightRays rays, spread as the cosine to the normal is: fills its sights with the groups
/// of kSightGroup points on the mesh's own surface that they meet, group by group; rays that are missing see what is
/// around. And the depths and the groups' blends.
void look_around(const Mesh& mesh, PointCloud& cloud);

/// Fills the vertices and indices of a cloud that has its points.
void blend_points(const Mesh& mesh, PointCloud& cloud);

}  // namespace tyndall::translucency
