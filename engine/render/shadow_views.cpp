#include "render/shadow_views.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace tyndall {
namespace {

constexpr float kWidestCone = 1.309f;  // 75 degrees: wider maps waste their texels
constexpr int kSmallest = 64;
/// Texels that a filter reaches beyond a view's part of a face or cone.
constexpr float kFilterMargin = 3.0f;
/// Between equal (0) and logarithmic (1) splits of the cascades.
constexpr float kLogarithmic = 0.7f;

/// A box in light space: x right, y up, z toward the light.
struct LightBox {
    glm::vec3 low{INFINITY}, high{-INFINITY};
};

/// Reversed-Z along -Z; `far` 0 = infinite.
glm::mat4 perspective(float tan_half, float near, float far) {
    glm::mat4 clip(0.0f);
    clip[0][0] = clip[1][1] = 1.0f / tan_half;
    clip[2][3] = -1.0f;
    clip[2][2] = far > near ? near / (far - near) : 0.0f;
    clip[3][2] = far > near ? near * far / (far - near) : near;
    return clip;
}

glm::mat4 orthographic(const LightBox& box) {
    const glm::vec3 extent = box.high - box.low;
    const glm::vec3 scale(2.0f / extent.x, 2.0f / extent.y, 1.0f / extent.z);
    glm::mat4 clip(1.0f);
    for (int i = 0; i < 3; ++i) {
        clip[i][i] = scale[i];
        clip[3][i] = -box.low[i] * scale[i] - (i < 2 ? 1.0f : 0.0f);
    }
    return clip;
}

/// World to the space of an eye with these axes.
glm::mat4 look(const glm::vec3& right, const glm::vec3& up, const glm::vec3& back, const glm::vec3& eye) {
    const glm::mat3 rotation = glm::transpose(glm::mat3(right, up, back));
    glm::mat4 view(rotation);
    view[3] = glm::vec4(-(rotation * eye), 1.0f);
    return view;
}

int power_of_two(int size, int largest) {
    return std::min(static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::max(size, kSmallest)))), largest);
}

/// A step that is a power of two and at most 1/32 of the extent: boxes rounded to it do not follow every motion.
float rounding_step(float extent) {
    return std::exp2(std::ceil(std::log2(std::max(extent, 1e-3f)))) / 64.0f;
}

/// Grows [low, high] to whole steps, and at least half a step.
void round_out(float& low, float& high) {
    const float step = rounding_step(high - low);
    low = std::floor(low / step - 0.5f) * step;
    high = std::ceil(high / step + 0.5f) * step;
}

class Planner {
 public:
    Planner(const RenderScene& scene, const Bounds& bounds, glm::vec2 tan_half_fov, const ShadowLimits& limits)
        : scene_(scene), bounds_(bounds), tan_half_fov_(tan_half_fov), limits_(limits) {}

    void add(size_t index) {
        const Light& light = scene_.lights[index];
        light_ = index;
        size_ = power_of_two(light.shadow.size, largest());
        if (light.kind == LightKind::directional)
            add_cascades(light);
        else if (light.kind == LightKind::spot && light.outer_angle < kWidestCone)
            add_cone(light);
        else
            add_faces(light);
    }

    std::vector<ShadowView> views_;

 private:
    [[nodiscard]] int largest() const {
        return static_cast<int>(std::bit_floor(static_cast<unsigned>(std::max(limits_.max_size, kSmallest))));
    }

    void add_perspective(const Light& light, const glm::mat4& view, float tan_half) {
        // The emitter's own body (a lamp's glass, a flame) is no occluder of it.
        const float near = std::max(0.02f, light.source_radius_m);
        const float wide = tan_half * static_cast<float>(size_) / (static_cast<float>(size_) - 2.0f * kFilterMargin);
        views_.push_back({.light = light_,
                          .clip_from_world = perspective(wide, near, light.range_m) * view,
                          .eye = glm::vec3(light.transform[3]),
                          .perspective = true,
                          .texel_m = 2.0f * wide / static_cast<float>(size_),
                          .size = size_});
    }

    void add_cone(const Light& light) {
        const glm::mat4& m = light.transform;
        add_perspective(light, look(glm::vec3(m[0]), glm::vec3(m[1]), glm::vec3(m[2]), glm::vec3(m[3])),
                        std::tan(std::max(light.outer_angle, 0.01f)));
    }

    void add_faces(const Light& light) {
        for (int face = 0; face < 6; ++face) {
            glm::vec3 back(0.0f), up(0.0f);
            back[face / 2] = face % 2 == 0 ? -1.0f : 1.0f;
            up[face / 2 == 1 ? 2 : 1] = 1.0f;
            add_perspective(light, look(glm::cross(up, back), up, back, glm::vec3(light.transform[3])), 1.0f);
        }
    }

    void add_cascades(const Light& light) {
        const glm::mat3 light_from_world = glm::transpose(glm::mat3(light.transform));
        LightBox whole;
        for (int corner = 0; corner < 8; ++corner) {
            const glm::vec3 at(corner & 1 ? bounds_.high.x : bounds_.low.x, corner & 2 ? bounds_.high.y : bounds_.low.y,
                               corner & 4 ? bounds_.high.z : bounds_.low.z);
            whole.low = glm::min(whole.low, light_from_world * at);
            whole.high = glm::max(whole.high, light_from_world * at);
        }
        for (int axis = 0; axis < 3; ++axis) round_out(whole.low[axis], whole.high[axis]);
        const int cascades = std::clamp(light.shadow.cascades, 1, 4);
        const float distance = std::max(light.shadow.distance_m, 1.0f);
        float near = 0.0f;
        for (int i = 1; i <= cascades; ++i) {
            const float far = split(static_cast<float>(i) / static_cast<float>(cascades), distance);
            LightBox box = cascade(light_from_world, near, far);
            const bool fits = box.high.x - box.low.x >= whole.high.x - whole.low.x &&
                              box.high.y - box.low.y >= whole.high.y - whole.low.y;
            if (fits) box = whole;
            box.low.z = whole.low.z;
            box.high.z = whole.high.z;
            add_orthographic(light, light_from_world, box, !fits);
            if (fits) return;
            near = far;
        }
    }

    /// Where the part `share` of the cascades ends, metres from the camera (Zhang et al. 2006).
    [[nodiscard]] static float split(float share, float distance) {
        const float start = 0.01f * distance;
        const float logarithmic = start * std::pow(distance / start, share);
        const float equal = start + (distance - start) * share;
        return kLogarithmic * logarithmic + (1.0f - kLogarithmic) * equal;
    }

    /// A square around the sphere that holds the frustum between two distances.
    [[nodiscard]] LightBox cascade(const glm::mat3& light_from_world, float near, float far) const {
        const float k2 = glm::dot(tan_half_fov_, tan_half_fov_);
        const float center = std::min(0.5f * (near + far) * (1.0f + k2), far);
        const float radius = std::sqrt((far - center) * (far - center) + far * far * k2);
        const float rounded = std::ceil(radius * 16.0f) / 16.0f;
        const float half = rounded * 1.14f;  // an eighth for the steps, and the filter
        const float texel = 2.0f * half / static_cast<float>(size_);
        const float step = std::max(1.0f, std::floor(0.25f * rounded / texel)) * texel;
        const glm::mat4& camera = scene_.camera.transform;
        glm::vec3 at = light_from_world * (glm::vec3(camera[3]) - center * glm::vec3(camera[2]));
        at = glm::vec3(std::round(at.x / step) * step, std::round(at.y / step) * step, 0.0f);
        return {at - half, at + half};
    }

    void add_orthographic(const Light& light, const glm::mat3& light_from_world, const LightBox& box, bool fades) {
        const glm::vec3 extent = box.high - box.low;
        const glm::vec3 above(0.5f * (box.low.x + box.high.x), 0.5f * (box.low.y + box.high.y), box.high.z);
        views_.push_back({.light = light_,
                          .clip_from_world = orthographic(box) * glm::mat4(light_from_world),
                          .eye = glm::mat3(light.transform) * above,
                          .fades = fades,
                          .texel_m = std::max(extent.x, extent.y) / static_cast<float>(size_),
                          .size = size_});
    }

    const RenderScene& scene_;
    const Bounds& bounds_;
    glm::vec2 tan_half_fov_;
    const ShadowLimits& limits_;
    size_t light_ = 0;
    int size_ = 0;
};

size_t bytes_of(const std::vector<ShadowView>& views) {
    size_t texels = 0;
    for (const ShadowView& view : views) texels += static_cast<size_t>(view.size) * static_cast<size_t>(view.size);
    return texels * sizeof(float);
}

/// Every second bit of a number, from the lowest.
int even_bits(uint32_t bits) {
    uint32_t result = 0;
    for (uint32_t i = 0; i < 16; ++i) result |= (bits >> (2 * i) & 1u) << i;
    return static_cast<int>(result);
}

/// Squares of powers of two along a Z-order curve, largest first, leave no gaps and cross no page.
void pack(ShadowPlan& plan) {
    std::vector<ShadowView*> order;
    for (ShadowView& view : plan.views) order.push_back(&view);
    std::ranges::stable_sort(order, std::greater<>(), &ShadowView::size);
    plan.page_size = order.empty() ? 1 : order.front()->size;
    const uint64_t page_texels = static_cast<uint64_t>(plan.page_size) * static_cast<uint64_t>(plan.page_size);
    uint64_t used = 0;
    for (ShadowView* view : order) {
        const auto in_page = static_cast<uint32_t>(used % page_texels);
        view->page = static_cast<int>(used / page_texels);
        view->corner = {even_bits(in_page), even_bits(in_page >> 1)};
        used += static_cast<uint64_t>(view->size) * static_cast<uint64_t>(view->size);
    }
    plan.pages = std::max(1, static_cast<int>((used + page_texels - 1) / page_texels));
}

}  // namespace

ShadowPlan plan_shadows(const RenderScene& scene, const Bounds& bounds, glm::vec2 tan_half_fov,
                        const ShadowLimits& limits) {
    ShadowPlan plan;
    const bool anything = glm::all(glm::lessThanEqual(bounds.low, bounds.high)) &&
                          !glm::any(glm::isinf(bounds.low + bounds.high)) &&
                          !glm::any(glm::isnan(bounds.low + bounds.high));
    if (!anything) return plan;
    // Halving the sizes of all lights alike until they fit keeps the balance that the author chose.
    ShadowLimits fitting = limits;
    for (;; fitting.max_size /= 2) {
        Planner planner(scene, bounds, tan_half_fov, fitting);
        for (size_t i = 0; i < scene.lights.size(); ++i)
            if (scene.lights[i].shadow.enabled) planner.add(i);
        plan.views = std::move(planner.views_);
        if (bytes_of(plan.views) <= limits.max_bytes || fitting.max_size <= kSmallest) break;
    }
    for (const ShadowView& view : plan.views)
        plan.reduced = plan.reduced || view.size < scene.lights[view.light].shadow.size;
    pack(plan);
    return plan;
}

}  // namespace tyndall
