#include "interior_block.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "physics/physics.h"
#include "physics/tables.h"

namespace tyndall::translucency {
namespace {

/// Light begins to spread where it first collides. What leaves again has collided nearer than the mean: of the places
/// tried, two fifths of the mean free path are nearest to traced spheres.
constexpr float kFirstPath = 0.4f;
/// Light that leaves so many mean free paths from where it entered has forgotten where that was (by 1 - 1/e).
constexpr float kDeepPaths = 4.0f;
/// Boundaries smoother than this mirror as Fresnel says.
constexpr float kSmooth = 0.05f;

glm::vec3 slanted(const InteriorKey& key, const glm::vec3& straight, float i) {
    if (key.model != Model::directional || key.scaling != Scaling::exact) return glm::vec3(1.0f);
    const glm::vec3 returned = directional_returned(key.optics, i / float(physics::HalfSpace::kCosines - 1));
    return straight / glm::max(returned, 0.1f * straight + 1e-12f);
}

/// A Gaussian's integral over a plane is its weight over its rate, and rates double from one to the next narrower.
void add_plane_shares(InteriorBlock& block) {
    constexpr int kLast = RadialKernel::kGaussians - 1;
    glm::vec3 all(0.0f);
    for (int k = kLast; k >= 0; --k) all += std::ldexp(1.0f, k - kLast) * glm::vec3(block.kernel[k]);
    const glm::vec3 inverse = 1.0f / glm::max(all, glm::vec3(1e-30f));
    for (int pair = 0; pair < RadialKernel::kGaussians / 2; ++pair) {
        const int k = kLast - 2 * pair;
        const glm::vec3 both = glm::vec3(block.kernel[k]) + 0.5f * glm::vec3(block.kernel[k - 1]);
        glm::vec4& shares = pair < 4 ? block.plane_wide : block.plane_narrow;
        shares[pair % 4] = glm::dot(both * inverse, glm::vec3(1.0f / 3.0f)) * std::ldexp(1.0f, -2 * pair);
    }
}

/// Of light that is even over the hemisphere.
float diffuse_entering(float eta, float roughness) {
    if (eta <= 1.0f) return 1.0f;
    if (roughness < kSmooth) return physics::diffuse_transmission(1.0f / eta);
    constexpr int kSteps = 64;
    float sum = 0.0f;
    for (int i = 0; i < kSteps; ++i) {
        const float cosine = (float(i) + 0.5f) / float(kSteps);
        const float mirrored = physics::fresnel_dielectric(cosine, eta) * mirrored_by_rough(cosine, eta, roughness);
        sum += 2.0f * cosine * (1.0f - mirrored) / float(kSteps);
    }
    return sum;
}

}  // namespace

float mirrored_by_rough(float cosine, float eta, float roughness) {
    if (eta <= 1.0f || roughness < kSmooth) return 1.0f;
    constexpr float kGrazing = 0.03f;  // the lobe's integral is not defined at 0
    constexpr int kSteps = 24;
    const float c = std::max(cosine, kGrazing), root = (eta - 1.0f) / (eta + 1.0f), f0 = root * root;
    const glm::vec2 lobe = physics::ggx_directional_albedo(c, roughness, kSteps);
    return (f0 * lobe.x + lobe.y) / (f0 + (1.0f - f0) * std::pow(1.0f - c, 5.0f));
}

glm::vec3 body_albedo(const Optics& optics, float body_radius) {
    const glm::vec3 albedo = optics.albedo();
    if (!(body_radius > 0.0f)) return albedo;
    const glm::vec3 x = body_radius * glm::sqrt(3.0f * optics.sigma_a * (optics.sigma_s_reduced + optics.sigma_a));
    glm::vec3 taken;
    for (int i = 0; i < 3; ++i) taken[i] = x[i] < 1e-2f ? x[i] / 3.0f : 1.0f / std::tanh(x[i]) - 1.0f / x[i];
    return 1.0f - (1.0f - albedo) * taken * taken;
}

float mean_free_path(const Optics& optics) {
    const glm::vec3 extinction = optics.sigma_s_reduced + optics.sigma_a;
    return 3.0f / std::max(extinction.x + extinction.y + extinction.z, 1e-6f);
}

float deep_distance(const Optics& optics) {
    return kDeepPaths * mean_free_path(optics);
}

InteriorBlock interior_block(const InteriorKey& key) {
    const Optics& optics = key.optics;
    const bool exact = key.scaling == Scaling::exact;
    const glm::vec3 endless = optics.albedo();
    const physics::HalfSpace body(exact ? body_albedo(optics, key.body_radius) : endless, optics.eta);
    InteriorBlock block{};
    for (size_t i = 0; i < physics::HalfSpace::kCosines; ++i) {
        block.leaving[i] = glm::vec4(body.table()[i], 0.0f);
        block.deep[i] = glm::vec4(body.deep()[i], 0.0f);
    }
    block.mean_leaving = glm::vec4(body.diffuse_leaving(), 0.0f);
    block.base_entering = glm::vec4(physics::HalfSpace(endless, optics.eta).diffuse_leaving(),
                                    diffuse_entering(optics.eta, optics.roughness));
    for (int i = 0; i < kRoughCosines; ++i) {
        const float root = float(i) / float(kRoughCosines - 1);
        block.rough[i].x = mirrored_by_rough(root * root, optics.eta, optics.roughness);
    }
    const float path = mean_free_path(optics);
    block.boundary = glm::vec4(optics.eta, exact ? kFirstPath * path / optics.eta : 0.0f, exact ? 1.0f : 0.0f, 0.0f);
    const RadialKernel kernel(optics, key.model, key.scaling, key.piece_radius);
    std::ranges::copy(kernel.weights(), block.kernel);
    block.kernel_rate = glm::vec4(kernel.rate(), std::numbers::log2e_v<float> / deep_distance(optics), 0.0f, 0.0f);
    add_plane_shares(block);
    block.sigma_s_reduced = glm::vec4(optics.sigma_s_reduced, 0.0f);
    block.sigma_a = glm::vec4(optics.sigma_a, 0.0f);
    for (size_t i = 0; i < physics::HalfSpace::kCosines; ++i)
        block.slanted[i] = glm::vec4(slanted(key, kernel.returned(), float(i)), 0.0f);
    block.published = glm::vec4(exact ? 1.0f / glm::max(kernel.returned(), glm::vec3(1e-12f)) : glm::vec3(1.0f), 0.0f);
    return block;
}

}  // namespace tyndall::translucency
