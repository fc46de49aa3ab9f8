#include "radial_kernel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "physics/non_negative.h"
#include "physics/physics.h"

namespace tyndall::translucency {
namespace {

constexpr int kBeamSources = 32;

using Gaussians = std::array<double, RadialKernel::kGaussians>;

}  // namespace

glm::vec3 Optics::albedo() const {
    return sigma_s_reduced / glm::max(sigma_s_reduced + sigma_a, glm::vec3(1e-6f));
}

Optics optics_of(const ScatteringInterior& interior) {
    const glm::vec3 reduced = interior.sigma_s_per_m * (glm::vec3(1.0f) - mean_cosine(interior.phase));
    return {reduced, interior.sigma_a_per_m, interior.eta, interior.roughness};
}

glm::vec3 exitance(Model model, const Optics& optics, float r) {
    const physics::Diffusion m = physics::make_diffusion(optics.sigma_s_reduced, optics.sigma_a, 0.0f, optics.eta);
    switch (model) {
        case Model::normalised:
            return physics::normalised_diffusion(m.albedo_reduced, 1.0f / m.sigma_t_reduced, r);
        case Model::better:
            return physics::better_dipole(m, r);
        case Model::standard:
            return physics::standard_dipole(m, r);
        case Model::photon_beams:
            return physics::photon_beam_diffusion(m, r, kBeamSources);
        case Model::directional:
            return physics::directional_dipole(m, glm::vec3(r, 0, 0), glm::vec3(0, 0, -1), glm::vec3(0, 0, 1),
                                               glm::vec3(0, 0, 1));
    }
    return glm::vec3(0.0f);
}

glm::vec3 directional_returned(const Optics& optics, float cosine) {
    constexpr int kAngles = 24, kDistances = 120;
    const physics::Diffusion m = physics::make_diffusion(optics.sigma_s_reduced, optics.sigma_a, 0.0f, optics.eta);
    const glm::vec3 path = 1.0f / glm::max(optics.sigma_s_reduced + optics.sigma_a, glm::vec3(1e-6f));
    const float first = std::log(1e-3f * std::min({path.x, path.y, path.z}));
    const float step = (std::log(1e3f * std::max({path.x, path.y, path.z})) - first) / kDistances;
    const glm::vec3 normal(0, 0, 1), way(std::sqrt(std::max(1.0f - cosine * cosine, 0.0f)), 0.0f, -cosine);
    glm::dvec3 sum(0.0);
    for (int i = 0; i < kDistances; ++i) {
        const float r = std::exp(first + (float(i) + 0.5f) * step);
        glm::dvec3 ring(0.0);
        for (int k = 0; k < kAngles; ++k) {
            const float angle = std::numbers::pi_v<float> * (float(k) + 0.5f) / kAngles;  // the other half is alike
            const glm::vec3 x(r * std::cos(angle), r * std::sin(angle), 0.0f);
            ring += glm::dvec3(physics::directional_dipole(m, x, way, normal, normal));
        }
        sum += ring * (2.0 * std::numbers::pi / kAngles * double(r * r * step));
    }
    return glm::vec3(sum);
}

RadialKernel::RadialKernel(const Optics& optics, Model model, Scaling scaling, float piece_radius)
    : piece_radius_(double(piece_radius)) {
    integrate(optics, model);
    const glm::dvec3 all = within_.back();
    returned_ = glm::vec3(all);
    const glm::dvec3 scale = scaling == Scaling::exact ? 1.0 / glm::max(all, glm::dvec3(1e-12)) : glm::dvec3(1.0);
    for (glm::dvec3& share : within_) share *= scale;
    far_ = [=](float r) { return glm::vec3(scale * glm::dvec3(exitance(model, optics, r))); };
    fit();
}

/// Fills `within_`: the integral of 2 pi r times the exitance, in equal steps of log r.
void RadialKernel::integrate(const Optics& optics, Model model) {
    const glm::dvec3 path = 1.0 / glm::max(glm::dvec3(optics.sigma_s_reduced + optics.sigma_a), glm::dvec3(1e-6));
    first_ = std::log(1e-4 * std::min({path.x, path.y, path.z}));
    const double last = std::log(1e4 * std::max({path.x, path.y, path.z}));
    step_ = (last - first_) / kSteps;
    within_.assign(1, glm::dvec3(0.0));
    for (int i = 0; i < kSteps; ++i) {
        const double r = std::exp(first_ + (i + 0.5) * step_);
        within_.push_back(within_.back() +
                          2.0 * std::numbers::pi * r * r * step_ * glm::dvec3(exitance(model, optics, float(r))));
    }
}

glm::dvec3 RadialKernel::within(double r) const {
    const double x = (std::log(std::max(r, 1e-12)) - first_) / step_;
    if (x <= 0.0) return glm::dvec3(0.0);
    const size_t i = std::min(size_t(x), size_t(kSteps - 1));
    return glm::mix(within_[i], within_[i + 1], std::min(x - double(i), 1.0));
}

/// Of a disc `r` away, by rings about the origin: each lies in the disc with a part of its circle.
glm::vec3 RadialKernel::exact(float distance) const {
    constexpr int kRings = 48;
    const double r = double(distance), radius = piece_radius_;
    if (r > 6.0 * radius) return far_(distance);
    glm::dvec3 sum = r < radius ? within(radius - r) : glm::dvec3(0.0);
    const double low = std::abs(r - radius), high = r + radius;
    glm::dvec3 before = within(low);
    for (int i = 0; i < kRings; ++i) {
        const double outer = low + (high - low) * (i + 1.0) / kRings, middle = low + (high - low) * (i + 0.5) / kRings;
        const glm::dvec3 now = within(outer);
        const double cosine = (middle * middle + r * r - radius * radius) / (2.0 * middle * std::max(r, 1e-12));
        sum += (now - before) * (std::acos(std::clamp(cosine, -1.0, 1.0)) / std::numbers::pi);
        before = now;
    }
    return glm::vec3(sum / (std::numbers::pi * radius * radius));
}

/// Least squares with errors relative to the kernel, where there is light: from a part of the piece to 250 pieces away.
void RadialKernel::fit() {
    constexpr int kPlaces = 96;
    const double narrowest = 1.0 / (piece_radius_ * piece_radius_);
    rate_ = float(std::ldexp(narrowest, 1 - kGaussians));
    std::vector<physics::NonNegativeEquations> equations(3, physics::NonNegativeEquations(kGaussians));
    glm::dvec3 most(0.0);
    for (int i = 0; i < kPlaces; ++i) {
        const double r = 0.2 * piece_radius_ * std::pow(1250.0, double(i) / (kPlaces - 1));
        const glm::dvec3 wanted(exact(float(r)));
        if (i == 0) most = wanted;
        Gaussians basis;
        for (size_t k = 0; k < basis.size(); ++k) basis[k] = std::exp(-std::ldexp(narrowest, -int(k)) * r * r);
        for (int c = 0; c < 3; ++c)
            equations[size_t(c)].add(basis, wanted[c], 1.0 / (wanted[c] + 1e-9 * most[c] + 1e-300));
    }
    for (int c = 0; c < 3; ++c) {
        const std::vector<double> weights = equations[size_t(c)].solve();
        for (size_t k = 0; k < weights.size(); ++k) weights_[k][c] = float(weights[k]);
    }
}

glm::vec3 RadialKernel::at(float r) const {
    float g = std::exp(-rate_ * r * r);
    glm::vec3 sum(0.0f);
    for (size_t k = kGaussians; k-- > 0; g *= g) sum += g * glm::vec3(weights_[k]);
    return sum;
}

}  // namespace tyndall::translucency
