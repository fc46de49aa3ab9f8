#include "shadows/shadow_fit.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>

namespace tyndall::participating_media {
namespace {

constexpr float kWidestPyramid = 3.0f;  ///< tan of the half angle; beyond, texels in its corners are too small

constexpr int kStepsAcross = 8;  ///< in which a level's box moves

/// A rectangle of u, v before it becomes [0, 1]^2.
struct Rectangle {
    glm::vec2 low{1e30f}, high{-1e30f};
    void add(glm::vec2 p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    /// With a texel more on each side.
    [[nodiscard]] Rectangle with_margin(int size) const {
        const glm::vec2 texel = glm::max((high - low) / static_cast<float>(size - 2), glm::vec2(1e-6f));
        return {low - texel, high + texel};
    }
};

glm::vec3 axis(const Light& light, int column) {
    return glm::normalize(glm::vec3(light.transform[column]));
}

ShadowFit parallel_fit(const Light& light, const UnevenMedia& media, int size) {
    const glm::vec3 right = axis(light, 0), up = axis(light, 1), travel = -axis(light, 2);
    Rectangle all;
    float near = 1e30f, far = -1e30f;
    for (const glm::vec3& corner : media.corners) {
        all.add({glm::dot(corner, right), glm::dot(corner, up)});
        near = std::min(near, glm::dot(corner, travel));
        far = std::max(far, glm::dot(corner, travel));
    }
    all = all.with_margin(size);
    const glm::vec2 extent = all.high - all.low;
    const float depth = std::max(far - near, 1e-6f);
    ShadowFit fit{.kind = MapKind::parallel, .near_m = 0.0f, .far_m = depth};
    fit.origin = all.low.x * right + all.low.y * up + near * travel;
    fit.base = travel;
    fit.across = extent.x * right;
    fit.up = extent.y * up;
    fit.map_from_world = glm::transpose(
        glm::mat4(glm::vec4(right / extent.x, -all.low.x / extent.x), glm::vec4(up / extent.y, -all.low.y / extent.y),
                  glm::vec4(travel / depth, -near / depth), glm::vec4(0.0f, 0.0f, 0.0f, 1.0f)));
    return fit;
}

/// From a light with a place along an axis; `limit` is the tangent of the light's own half angle. Nothing when the
/// media lie outside of it.
std::optional<ShadowFit> pyramid_fit(const Light& light, const UnevenMedia& media, int size, const glm::mat3& axes,
                                     float limit) {
    const glm::vec3 place(light.transform[3]);
    Rectangle all;
    for (const glm::vec3& corner : media.corners) {
        const glm::vec3 local = glm::transpose(axes) * (corner - place);
        // beside the light or behind it the rectangle has no end
        const float ahead = std::max(local.z, 1e-3f * glm::length(local));
        all.add(glm::clamp(glm::vec2(local) / ahead, -limit, limit));
    }
    if (all.low.x >= all.high.x || all.low.y >= all.high.y) return std::nullopt;
    all = all.with_margin(size);
    const glm::vec2 extent = all.high - all.low;
    ShadowFit fit{.kind = MapKind::pyramid, .origin = place};
    fit.base = axes[2] + all.low.x * axes[0] + all.low.y * axes[1];
    fit.across = extent.x * axes[0];
    fit.up = extent.y * axes[1];
    const auto row = [&](glm::vec3 v) { return glm::vec4(v, -glm::dot(v, place)); };
    fit.map_from_world =
        glm::transpose(glm::mat4(row((axes[0] - all.low.x * axes[2]) / extent.x),
                                 row((axes[1] - all.low.y * axes[2]) / extent.y), glm::vec4(0.0f), row(axes[2])));
    return fit;
}

glm::mat3 looking_at(const glm::vec3& forward) {
    const glm::vec3 side = std::abs(forward.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 right = glm::normalize(glm::cross(forward, side));
    return {right, glm::cross(right, forward), forward};
}

std::optional<ShadowFit> fit_around(const Light& light, const UnevenMedia& media, int size) {
    const glm::vec3 place(light.transform[3]);
    const float limit = light.kind == LightKind::spot ? std::tan(std::min(light.outer_angle, 1.57f)) : 1e6f;
    if (limit <= kWidestPyramid)
        return pyramid_fit(light, media, size, {axis(light, 0), axis(light, 1), -axis(light, 2)}, limit);
    const glm::vec3 toward = media.bounds.centre() - place;
    if (!media.bounds.contains(place) && glm::length(toward) > 0.0f) {
        const glm::mat3 axes = looking_at(glm::normalize(toward));
        const bool within = std::ranges::all_of(media.corners, [&](const glm::vec3& corner) {
            const glm::vec3 local = glm::transpose(axes) * (corner - place);
            return local.z > 0.0f && std::max(std::abs(local.x), std::abs(local.y)) < kWidestPyramid * local.z;
        });
        if (within) return pyramid_fit(light, media, size, axes, kWidestPyramid);
    }
    return ShadowFit{.kind = MapKind::octahedron, .origin = place};
}

}  // namespace

bool is_uneven(const DensityField& density) {
    return std::holds_alternative<NoiseDensity>(density) || std::holds_alternative<GradientDensity>(density) ||
           std::holds_alternative<GridDensity>(density) || std::holds_alternative<ProductDensity>(density);
}

UnevenMedia uneven_media(const std::vector<Medium>& media, const RenderScene& scene) {
    UnevenMedia uneven;
    for (const Medium& medium : media) {
        if (!is_uneven(medium.density)) continue;
        const glm::mat4 box = medium_box(medium, scene);
        for (int k = 0; k < 8; ++k) {
            const glm::vec4 corner(static_cast<float>(k & 1) - 0.5f, static_cast<float>((k >> 1) & 1) - 0.5f,
                                   static_cast<float>(k >> 2) - 0.5f, 1.0f);
            uneven.corners.emplace_back(box * corner);
            uneven.bounds.add(uneven.corners.back());
        }
    }
    return uneven;
}

std::optional<ShadowFit> fit_shadow_map(const Light& light, const UnevenMedia& media, int size) {
    if (media.empty()) return std::nullopt;
    if (light.kind == LightKind::directional) return parallel_fit(light, media, size);
    std::optional<ShadowFit> fit = fit_around(light, media, size);
    if (!fit) return fit;
    const glm::vec3 place(light.transform[3]);
    fit->near_m = glm::distance(place, glm::clamp(place, media.bounds.low, media.bounds.high));
    fit->far_m = 0.0f;
    for (const glm::vec3& corner : media.corners) fit->far_m = std::max(fit->far_m, glm::distance(place, corner));
    if (light.range_m > 0.0f) fit->far_m = std::min(fit->far_m, light.range_m);
    if (fit->far_m <= fit->near_m) return std::nullopt;
    return fit;
}

std::vector<Bounds> clipmap_boxes(const Bounds& media, const glm::vec3& camera, int levels, int voxels) {
    std::vector<Bounds> boxes;
    const glm::vec3 whole = glm::max(media.size(), glm::vec3(1e-4f));
    const int steps = std::min(kStepsAcross, voxels);
    for (int level = 0; level < levels; ++level) {
        const int shrink = 1 << (levels - 1 - level);
        const glm::vec3 extent = whole / static_cast<float>(shrink);
        const glm::vec3 step = extent / static_cast<float>(steps);
        const glm::vec3 wanted = glm::round((camera - 0.5f * extent - media.low) / step);
        const glm::vec3 at = glm::clamp(wanted, glm::vec3(0.0f), glm::vec3(static_cast<float>((shrink - 1) * steps)));
        Bounds box;
        box.low = media.low + at * step;
        box.high = box.low + extent;
        boxes.push_back(box);
    }
    return boxes;
}

}  // namespace tyndall::participating_media
