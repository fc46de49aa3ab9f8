#include "quick/quick_body.h"

#include <algorithm>
#include <cmath>

#include "thickness/thickness_shares.h"

namespace tyndall::translucency {
namespace {

/// leaving_at or deep_at of shaders/interior.glsl.
glm::vec3 at_cosine(const glm::vec4 (&table)[physics::HalfSpace::kCosines], float cosine, float eta) {
    constexpr int kLast = int(physics::HalfSpace::kCosines) - 1;
    const float inside = std::sqrt(std::max(1.0f - (1.0f - cosine * cosine) / (eta * eta), 0.0f));
    const float x = inside * float(kLast);
    const int i = std::min(int(x), kLast - 1);
    return glm::mix(glm::vec3(table[i]), glm::vec3(table[i + 1]), x - float(i));
}

std::vector<glm::vec4> leaving_patterns(const InteriorBlock& block) {
    const bool exact = block.boundary.z > 0.0f;
    const glm::vec3 unit = 1.0f / glm::max(glm::vec3(block.base_entering), glm::vec3(1e-4f));
    const glm::vec3 mean = glm::vec3(block.mean_leaving);
    std::vector<glm::vec4> patterns(size_t(2 * QuickBody::kCosines), glm::vec4(unit, 0.0f));
    for (int i = 0; exact && i < QuickBody::kCosines; ++i) {
        const float cosine = float(i) / float(QuickBody::kCosines - 1), eta = block.boundary.x;
        const glm::vec3 near = at_cosine(block.leaving, cosine, eta) / glm::max(mean, glm::vec3(1e-6f));
        patterns[size_t(i)] = glm::vec4(near * mean * unit, 0.0f);
        patterns[size_t(QuickBody::kCosines + i)] = glm::vec4(at_cosine(block.deep, cosine, eta) * mean * unit, 0.0f);
    }
    return patterns;
}

}  // namespace

bool QuickBody::update(const Surface& surface, const TranslucencySettings& settings, PaintStore& paints) {
    const bool reshaped = size.update(surface.mesh->mesh, glm::mat3(surface.transform));
    const Optics optics = optics_of(*surface.interior);
    const bool is_new =
        interior.update({optics, settings.model, settings.scaling, mean_free_path(optics), size.radius});
    if (is_new || reshaped) {
        wrap = wrap_amount(optics, settings.model, size.radius);
        patterns = leaving_patterns(interior.block());
        farthest_m = glm::distance(surface.bounds.low, surface.bounds.high);
        passing = table_of_passing(optics, settings.model, farthest_m);
    }
    interior.paint(paints.of(surface, settings.model), surface);
    return is_new || reshaped;
}

}  // namespace tyndall::translucency
