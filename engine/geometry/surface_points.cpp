#include "geometry/surface_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>

#include "core/parallel.h"

namespace tyndall {
namespace {

constexpr double kFragmentsAPiece = 8.0;
/// How far apart opposite normals count, in radii of a piece.
constexpr float kNormalWeight = 1.5f;

/// A small piece of a triangle, and the same in the six axes of the tree.
struct Fragment {
    glm::vec3 position, normal;
    float area;
};

float axis_of(const Fragment& fragment, int axis, float normal_scale) {
    return axis < 3 ? fragment.position[axis] : normal_scale * fragment.normal[axis - 3];
}

/// Nothing where there is no direction, which sorts like any other; not a number would not.
glm::vec3 unit_or_none(const glm::vec3& v) {
    const float length = glm::length(v);
    return length > 0.0f && std::isfinite(length) ? v / length : glm::vec3(0.0f);
}

double area_of(const Mesh& mesh, size_t triangle) {
    const std::uint32_t* i = &mesh.indices[3 * triangle];
    const glm::vec3 &a = mesh.positions[i[0]], &b = mesh.positions[i[1]], &c = mesh.positions[i[2]];
    return 0.5 * double(glm::length(glm::cross(b - a, c - a)));
}

/// Cuts a triangle into k * k equal ones.
void cut(const Mesh& mesh, size_t triangle, double area, int k, std::vector<Fragment>& fragments) {
    const std::uint32_t* i = &mesh.indices[3 * triangle];
    const std::array<glm::vec3, 3> p{mesh.positions[i[0]], mesh.positions[i[1]], mesh.positions[i[2]]};
    const glm::vec3 face = glm::cross(p[1] - p[0], p[2] - p[0]);
    std::array<glm::vec3, 3> n{face, face, face};
    if (!mesh.normals.empty()) n = {mesh.normals[i[0]], mesh.normals[i[1]], mesh.normals[i[2]]};
    const auto add = [&](float u, float v) {
        const glm::vec3 at = (1.0f - u - v) * p[0] + u * p[1] + v * p[2];
        glm::vec3 normal = (1.0f - u - v) * n[0] + u * n[1] + v * n[2];
        if (!(glm::dot(normal, normal) > 0.0f)) normal = face;
        fragments.push_back({at, unit_or_none(normal), float(area / (double(k) * double(k)))});
    };
    const float step = 1.0f / float(k), third = step / 3.0f;
    for (int y = 0; y < k; ++y)
        for (int x = 0; x + y < k; ++x) {
            add(float(x) * step + third, float(y) * step + third);
            if (x + y + 1 < k) add(float(x) * step + 2.0f * third, float(y) * step + 2.0f * third);
        }
}

std::vector<Fragment> fragments_of(const Mesh& mesh, double largest) {
    std::vector<Fragment> fragments;
    for (size_t t = 0; t < mesh.triangle_count(); ++t) {
        const double area = area_of(mesh, t);
        if (!(area > 0.0) || !std::isfinite(area)) continue;
        cut(mesh, t, area, int(std::ceil(std::sqrt(std::max(area / largest, 1.0)))), fragments);
    }
    return fragments;
}

/// The axis along which the fragments are spread most, by variance.
int widest_axis(std::span<const Fragment> fragments, float normal_scale) {
    std::array<double, 6> sum{}, square{};
    double weight = 0.0;
    const glm::vec3 origin = fragments.front().position;
    for (const Fragment& fragment : fragments) {
        weight += double(fragment.area);
        for (int axis = 0; axis < 6; ++axis) {
            const double x =
                double(axis < 3 ? fragment.position[axis] - origin[axis] : axis_of(fragment, axis, normal_scale));
            sum[size_t(axis)] += double(fragment.area) * x;
            square[size_t(axis)] += double(fragment.area) * x * x;
        }
    }
    int widest = 0;
    double most = -1.0;
    for (size_t axis = 0; axis < 6; ++axis) {
        const double variance = square[axis] / weight - (sum[axis] / weight) * (sum[axis] / weight);
        if (variance > most) {
            most = variance;
            widest = int(axis);
        }
    }
    return widest;
}

/// Moves what belongs in the lower half of the area to the front; returns how many that are, at least one on each side.
size_t halve(std::span<Fragment> fragments, float normal_scale) {
    const int axis = widest_axis(fragments, normal_scale);
    std::ranges::sort(fragments, [&](const Fragment& a, const Fragment& b) {
        return axis_of(a, axis, normal_scale) < axis_of(b, axis, normal_scale);
    });
    double total = 0.0;
    for (const Fragment& fragment : fragments) total += double(fragment.area);
    double sum = 0.0;
    size_t count = 0;
    while (count + 1 < fragments.size() && sum + 0.5 * double(fragments[count].area) < 0.5 * total)
        sum += double(fragments[count++].area);
    return std::max<size_t>(count, 1);
}

/// The fragment nearest to the middle, with the area of all.
SurfacePoint piece_of(std::span<const Fragment> fragments) {
    glm::dvec3 middle(0.0);
    double area = 0.0;
    for (const Fragment& fragment : fragments) {
        middle += double(fragment.area) * glm::dvec3(fragment.position);
        area += double(fragment.area);
    }
    const glm::vec3 centre(middle / area);
    const auto distance = [&](const Fragment& fragment) {
        const glm::vec3 d = fragment.position - centre;
        return glm::dot(d, d);
    };
    const Fragment& nearest = *std::ranges::min_element(fragments, {}, distance);
    return {nearest.position, float(area), nearest.normal};
}

/// `points` gets 2^levels pieces of the fragments.
void split(std::span<Fragment> fragments, int levels, float normal_scale, SurfacePoint* points) {
    if (levels == 0 || fragments.size() == 1) {  // one alone is shared
        const size_t count = size_t(1) << size_t(levels);
        SurfacePoint piece = piece_of(fragments);
        piece.area /= float(count);
        std::fill_n(points, count, piece);
        return;
    }
    const size_t low = halve(fragments, normal_scale);
    const std::array<std::span<Fragment>, 2> halves{fragments.subspan(0, low), fragments.subspan(low)};
    parallel_for(0, 2, levels > 8 ? 1 : 2, [&](size_t first, size_t last) {
        for (size_t half = first; half < last; ++half)
            split(halves[half], levels - 1, normal_scale, points + half * (size_t(1) << size_t(levels - 1)));
    });
}

}  // namespace

std::vector<SurfacePoint> sample_surface(const Mesh& mesh, int levels) {
    double area = 0.0;
    for (size_t t = 0; t < mesh.triangle_count(); ++t) area += area_of(mesh, t);
    const size_t count = size_t(1) << size_t(levels);
    if (!(area > 0.0) || !std::isfinite(area)) return {};
    const double piece = area / double(count);
    std::vector<Fragment> fragments = fragments_of(mesh, piece / kFragmentsAPiece);
    std::vector<SurfacePoint> points(count);
    split(fragments, levels, kNormalWeight * float(std::sqrt(piece)), points.data());
    return points;
}

}  // namespace tyndall
