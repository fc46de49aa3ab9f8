#include "physics/skin_profiles.h"

#include <cmath>

#include "physics/half_space.h"
#include "physics/layered_diffusion.h"
#include "physics/physics.h"

namespace tyndall::physics {
namespace {

constexpr double kPerMm = 1e3, kPerCm = 1e2, kMm = 1e-3;

glm::dvec3 albedo_of(const std::vector<SolidLayer>& layers) {
    const SolidLayer& first = layers.front();
    if (layers.size() > 1 || !std::isinf(first.thickness_m)) return layered_response(layers, 0.0).reflected;
    const glm::vec3 albedo(first.sigma_s_reduced / (first.sigma_s_reduced + first.sigma_a));
    return HalfSpace(albedo, float(first.eta)).diffuse_leaving();
}

SolidLayer endless(const glm::dvec3& scattering_per_mm, const glm::dvec3& absorption_per_mm) {
    SolidLayer layer;
    layer.sigma_s_reduced = kPerMm * scattering_per_mm;
    layer.sigma_a = kPerMm * absorption_per_mm;
    layer.eta = 1.3;
    return layer;
}

}  // namespace

SolidProfile solid_profile(const std::vector<SolidLayer>& layers, int lobes) {
    const RadialProfile exact(solid_exitance(layers));
    return {fit_profile(exact, lobes), exact, albedo_of(layers), layers};
}

SolidProfile burley_profile(const glm::vec3& albedo, const glm::vec3& mean_free_path_m, int lobes) {
    const RadialProfile exact(
        [&](double r) { return glm::dvec3(normalised_diffusion(albedo, mean_free_path_m, float(r))); });
    return {fit_profile(exact, lobes), exact, glm::dvec3(albedo), {}};
}

SolidLayer jensen_skin1() {
    return endless({0.74, 0.88, 1.01}, {0.032, 0.17, 0.48});
}

SolidLayer jensen_skin2() {
    return endless({1.09, 1.59, 1.79}, {0.013, 0.070, 0.145});
}

std::vector<SolidLayer> three_layer_skin() {
    const auto layer = [](double thickness_mm, const glm::dvec3& absorption, const glm::dvec3& scattering) {
        return SolidLayer{kMm * thickness_mm, kPerCm * absorption, kPerCm * scattering, 1.4};
    };
    return {layer(0.25, {2.1, 2.1, 5.0}, {48.0, 60.0, 65.0}), layer(0.20, {0.16, 0.19, 0.30}, {32.0, 40.0, 46.0}),
            layer(INFINITY, {0.085, 1.0, 25.0}, {4.5, 4.7, 4.8})};
}

}  // namespace tyndall::physics
