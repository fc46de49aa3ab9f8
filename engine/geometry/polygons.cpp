#include "geometry/polygons.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <span>

#include "core/error.h"
#include "geometry/vertex_split.h"

namespace tyndall {
namespace {

/// Faces with more corners than this are cut as a fan: ear clipping takes cubic time in the worst case.
constexpr size_t kMostClipped = 256;

bool finite(glm::vec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Twice the area vector of a polygon (Newell's method).
glm::vec3 area_vector(std::span<const glm::vec3> points) {
    glm::vec3 sum(0.0f);
    for (size_t i = 0; i < points.size(); ++i)
        sum += glm::cross(points[i] - points[0], points[(i + 1) % points.size()] - points[0]);
    return sum;
}

/// Whether p lies in the triangle abc, seen along `normal`; its border counts.
bool inside(glm::vec3 p, glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 normal) {
    return glm::dot(glm::cross(b - a, p - a), normal) >= 0 && glm::dot(glm::cross(c - b, p - b), normal) >= 0 &&
           glm::dot(glm::cross(a - c, p - c), normal) >= 0;
}

/// Whether the corner at `i` of what is left can be cut off.
bool is_ear(std::span<const glm::vec3> points, const std::vector<std::uint32_t>& left, size_t i, glm::vec3 normal) {
    const size_t before = (i + left.size() - 1) % left.size(), after = (i + 1) % left.size();
    const glm::vec3 a = points[left[before]], b = points[left[i]], c = points[left[after]];
    if (glm::dot(glm::cross(b - a, c - b), normal) <= 0) return false;
    for (size_t k = 0; k < left.size(); ++k) {
        const glm::vec3 p = points[left[k]];
        const bool own = k == before || k == i || k == after || p == a || p == b || p == c;
        if (!own && inside(p, a, b, c, normal)) return false;
    }
    return true;
}

/// Triangles of a polygon, as indices of its points. Quads that are convex are cut along the shorter diagonal.
std::vector<std::array<std::uint32_t, 3>> cut(std::span<const glm::vec3> points) {
    std::vector<std::uint32_t> left(points.size());
    std::iota(left.begin(), left.end(), 0u);
    if (points.size() == 4 && glm::distance(points[1], points[3]) < glm::distance(points[0], points[2]))
        left = {1, 2, 3, 0};
    std::vector<std::array<std::uint32_t, 3>> triangles;
    const glm::vec3 normal = area_vector(points);
    while (left.size() > 3 && left.size() <= kMostClipped) {
        size_t ear = 1;
        while (ear < left.size() + 1 && !is_ear(points, left, ear % left.size(), normal)) ++ear;
        ear = ear > left.size() ? 1 : ear % left.size();  // none: the polygon crosses itself, any corner will do
        triangles.push_back({left[(ear + left.size() - 1) % left.size()], left[ear], left[(ear + 1) % left.size()]});
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    for (size_t i = 1; i + 1 < left.size(); ++i) triangles.push_back({left[0], left[i], left[i + 1]});
    return triangles;
}

}  // namespace

void validate(const PolygonMesh& polygons, const std::string& source) {
    const auto fail = [&](std::string message) { throw Error(Diagnostic{{source}, std::move(message), {}, {}}); };
    if (polygons.positions.empty()) fail("the file has no vertices");
    if (polygons.face_sizes.empty()) fail("the file has no faces");
    size_t corners = 0;
    for (const std::uint32_t size : polygons.face_sizes) {
        if (size < 3) fail(fmt::format("a face has {} corners", size));
        corners += size;
    }
    if (corners != polygons.corners.size()) fail("the faces do not match their corners");
    const auto check_indices = [&](const std::vector<std::uint32_t>& indices, size_t count, const char* what) {
        for (const std::uint32_t index : indices)
            if (index >= count) fail(fmt::format("a face names {} {} of {}", what, index, count));
    };
    const auto check_length = [&](size_t length, const char* what) {
        if (length != 0 && length != corners) fail(fmt::format("{} {} for {} corners", length, what, corners));
    };
    check_length(polygons.uv_corners.size(), "texture coordinates");
    check_length(polygons.normal_corners.size(), "normals");
    check_indices(polygons.corners, polygons.positions.size(), "vertex");
    check_indices(polygons.uv_corners, polygons.uvs.size(), "texture coordinate");
    check_indices(polygons.normal_corners, polygons.normals.size(), "normal");
    for (size_t i = 0; i < polygons.positions.size(); ++i)
        if (!finite(polygons.positions[i])) fail(fmt::format("the position of vertex {} is not finite", i));
    for (const glm::vec2 uv : polygons.uvs)
        if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) fail("a texture coordinate is not finite");
    for (const glm::vec3& normal : polygons.normals)
        if (!finite(normal)) fail("a normal is not finite");
}

Mesh triangulate(const PolygonMesh& polygons, const std::string& source) {
    validate(polygons, source);
    const bool has_uv = !polygons.uv_corners.empty();
    bool has_normals = !polygons.normal_corners.empty();
    for (const std::uint32_t index : polygons.normal_corners)  // a zero normal is none: they are better made anew
        has_normals = has_normals && glm::length(polygons.normals[index]) > 0;

    using Variant = std::pair<std::uint32_t, std::uint32_t>;  // texture coordinate, normal
    VertexSplitter<Variant> split(polygons.positions.size());
    Mesh mesh;
    mesh.indices.reserve(polygons.corners.size());
    std::vector<glm::vec3> points;
    size_t start = 0;
    for (const std::uint32_t size : polygons.face_sizes) {
        points.clear();
        for (size_t i = start; i < start + size; ++i) points.push_back(polygons.positions[polygons.corners[i]]);
        const auto add = [&](std::uint32_t corner) {
            const size_t c = start + corner;
            mesh.indices.push_back(split(polygons.corners[c], {has_uv ? polygons.uv_corners[c] : 0,
                                                               has_normals ? polygons.normal_corners[c] : 0}));
        };
        if (size == 3)
            for (std::uint32_t i = 0; i < 3; ++i) add(i);
        else
            for (const auto& triangle : cut(points))
                for (const std::uint32_t i : triangle) add(i);
        start += size;
    }
    mesh.positions = gathered(polygons.positions, split.sources());
    for (const auto& [uv, normal] : split.variants()) {
        if (has_uv) mesh.uv0.push_back(polygons.uvs[uv]);
        if (has_normals) mesh.normals.push_back(glm::normalize(polygons.normals[normal]));
    }
    mesh.bounds = bounds_of(mesh.positions);
    return mesh;
}

}  // namespace tyndall
