#include "radial_kernel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "physics/physics.h"

namespace tyndall::translucency {
namespace {

constexpr int kBeamSources = 32;
/// Light that leaves so many mean free paths from where it entered has forgotten where that was (by 1 - 1/e).
constexpr double kDeepPaths = 4.0;

}  // namespace

glm::vec3 Optics::albedo() const {
    return sigma_s_reduced / glm::max(sigma_s_reduced + sigma_a, glm::vec3(1e-6f));
}

Optics optics_of(const ScatteringInterior& interior) {
    const glm::vec3 reduced = interior.sigma_s_per_m * (glm::vec3(1.0f) - mean_cosine(interior.phase));
    return {reduced, interior.sigma_a_per_m, interior.eta};
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

RadialKernel::RadialKernel(const Optics& optics, Model model, Scaling scaling, float piece_radius)
    : piece_radius_(double(piece_radius)) {
    integrate(optics, model);
    const glm::dvec3 all = within_.back();
    returned_ = glm::vec3(all);
    if (scaling == Scaling::exact)
        for (glm::dvec3& share : within_) share /= glm::max(all, glm::dvec3(1e-12));
    const glm::vec3 extinction = optics.sigma_s_reduced + optics.sigma_a;
    fit(kDeepPaths * 3.0 / double(extinction.x + extinction.y + extinction.z));
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
        within_.push_back(within_.back() + 2.0 * std::numbers::pi * r * r * step_ *
                                               glm::dvec3(exitance(model, optics, float(r))));
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

/// Least squares with weights that are not negative, by descent along one coordinate after the other. Errors count
/// relative to the kernel, where there is light, from a part of the piece to sixteen octaves of r^2 on.
void RadialKernel::fit(double deep_path) {
    constexpr int kPlaces = 96, kSweeps = 400;
    const double narrowest = 2.0 / (piece_radius_ * piece_radius_);
    rate_ = float(std::ldexp(narrowest, 1 - kGaussians));
    std::vector<std::array<double, kGaussians>> basis(kPlaces);
    std::vector<glm::dvec4> wanted(kPlaces);
    for (int i = 0; i < kPlaces; ++i) {
        const double r = 0.2 * piece_radius_ * std::pow(1500.0, double(i) / (kPlaces - 1));
        const glm::dvec3 value = glm::max(glm::dvec3(exact(float(r))), glm::dvec3(1e-300));
        const double deep = 1.0 - std::exp(-r / deep_path);
        wanted[size_t(i)] = glm::dvec4(value, deep * glm::dot(value, glm::dvec3(0.2126, 0.7152, 0.0722)));
        for (int k = 0; k < kGaussians; ++k)
            basis[size_t(i)][size_t(k)] = std::exp(-std::ldexp(narrowest, -k) * r * r);
    }
    for (int channel = 0; channel < 4; ++channel) {
        const double most = wanted[0][channel];
        std::array<double, kGaussians> w{}, norm{};
        std::vector<double> left(kPlaces), scale(kPlaces);
        for (size_t i = 0; i < kPlaces; ++i) {
            scale[i] = 1.0 / (wanted[i][channel] + 1e-9 * most + 1e-300);
            left[i] = wanted[i][channel] * scale[i];
            for (size_t k = 0; k < kGaussians; ++k) norm[k] += basis[i][k] * basis[i][k] * scale[i] * scale[i];
        }
        for (int sweep = 0; sweep < kSweeps; ++sweep)
            for (size_t k = 0; k < kGaussians; ++k) {
                double slope = 0.0;
                for (size_t i = 0; i < kPlaces; ++i) slope += left[i] * basis[i][k] * scale[i];
                const double now = std::max(0.0, w[k] + slope / norm[k]), change = now - w[k];
                for (size_t i = 0; i < kPlaces; ++i) left[i] -= change * basis[i][k] * scale[i];
                w[k] = now;
            }
        for (size_t k = 0; k < kGaussians; ++k) weights_[k][channel] = float(w[k]);
    }
}

glm::vec4 RadialKernel::at(float r) const {
    float g = std::exp(-rate_ * r * r);
    glm::vec4 sum(0.0f);
    for (size_t k = kGaussians; k-- > 0; g *= g) sum += g * weights_[k];
    return sum;
}

}  // namespace tyndall::translucency
