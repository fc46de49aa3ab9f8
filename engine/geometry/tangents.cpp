#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/error.h"
#include "geometry/mesh.h"
#include "geometry/vertex_split.h"

namespace tyndall {
namespace {

/// Any unit vector orthogonal to a unit vector (Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 2017).
glm::vec3 any_orthogonal(glm::vec3 n) {
    const float sign = std::copysign(1.0f, n.z);
    const float a = -1.0f / (sign + n.z);
    return {1.0f + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x};
}

/// The part of `v` in the plane of unit `n`, of unit length; zero when there is none.
glm::vec3 in_plane(glm::vec3 v, glm::vec3 n) {
    const glm::vec3 flat = v - n * glm::dot(n, v);
    const float length = glm::length(flat);
    return length > 1e-6f * glm::length(v) && std::isfinite(length) ? flat / length : glm::vec3(0.0f);
}

/// The direction in which u grows over a triangle, and whether the picture is mirrored there.
struct FaceTangent {
    glm::vec3 direction{0.0f};  ///< zero when the UVs are degenerate
    bool mirrored = false;
};

FaceTangent face_tangent(const Mesh& mesh, const std::uint32_t* triangle) {
    const glm::vec3 e1 = mesh.positions[triangle[1]] - mesh.positions[triangle[0]];
    const glm::vec3 e2 = mesh.positions[triangle[2]] - mesh.positions[triangle[0]];
    const glm::vec2 d1 = mesh.uv0[triangle[1]] - mesh.uv0[triangle[0]];
    const glm::vec2 d2 = mesh.uv0[triangle[2]] - mesh.uv0[triangle[0]];
    const float area = d1.x * d2.y - d2.x * d1.y;
    if (!(std::abs(area) > 0) || !std::isfinite(area)) return {};
    const glm::vec3 direction = (e1 * d2.y - e2 * d1.y) * std::copysign(1.0f, area);
    const float length = glm::length(direction);
    if (!(length > 0) || !std::isfinite(length)) return {};
    // v grows downwards in glTF, so a picture that is not mirrored has a negative area here.
    return {direction / length, area > 0};
}

float angle_at(const Mesh& mesh, const std::uint32_t* triangle, size_t corner, glm::vec3 normal) {
    const glm::vec3 p = mesh.positions[triangle[corner]];
    const glm::vec3 a = in_plane(mesh.positions[triangle[(corner + 1) % 3]] - p, normal);
    const glm::vec3 b = in_plane(mesh.positions[triangle[(corner + 2) % 3]] - p, normal);
    return std::acos(std::clamp(glm::dot(a, b), -1.0f, 1.0f));
}

}  // namespace

void compute_tangents(Mesh& mesh) {
    if (mesh.normals.size() != mesh.positions.size()) throw Error("tangents need normals");
    mesh.tangents.clear();
    std::vector<bool> mirrored(mesh.positions.size(), false);
    std::vector<glm::vec3> sums(mesh.positions.size(), glm::vec3(0.0f));
    if (!mesh.uv0.empty()) {
        VertexSplitter<int> split(mesh.positions.size());
        std::vector<std::uint32_t> indices(mesh.indices.size());
        std::vector<FaceTangent> faces(mesh.triangle_count());
        for (size_t f = 0; f < faces.size(); ++f) {
            faces[f] = face_tangent(mesh, &mesh.indices[3 * f]);
            for (size_t c = 3 * f; c < 3 * f + 3; ++c) indices[c] = split(mesh.indices[c], faces[f].mirrored ? 1 : 0);
        }
        mesh.indices = std::move(indices);
        gather_vertices(mesh, split.sources());
        sums.assign(mesh.positions.size(), glm::vec3(0.0f));
        mirrored.assign(mesh.positions.size(), false);
        for (size_t i = 0; i < mirrored.size(); ++i) mirrored[i] = split.variants()[i] == 1;
        for (size_t c = 0; c < mesh.indices.size(); ++c) {
            const std::uint32_t vertex = mesh.indices[c];
            const glm::vec3 normal = mesh.normals[vertex];
            sums[vertex] +=
                in_plane(faces[c / 3].direction, normal) * angle_at(mesh, &mesh.indices[c - c % 3], c % 3, normal);
        }
    }
    mesh.tangents.resize(mesh.positions.size());
    for (size_t i = 0; i < sums.size(); ++i) {
        glm::vec3 tangent = in_plane(sums[i], mesh.normals[i]);
        if (tangent == glm::vec3(0.0f)) tangent = any_orthogonal(mesh.normals[i]);
        mesh.tangents[i] = glm::vec4(tangent, mirrored[i] ? -1.0f : 1.0f);
    }
}

}  // namespace tyndall
