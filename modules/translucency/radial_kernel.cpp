#include "radial_kernel.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "physics/physics.h"

namespace tyndall::translucency {
namespace {

constexpr int kBeamSources = 32;
/// Light that leaves so many mean free paths from where it entered has forgotten where that was (by 1 - 1/e).
constexpr double kDeepPaths = 4.0;
constexpr uint32_t kFractionBits = 23 - 4;  ///< of a float's mantissa below a sixteenth of an octave

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

RadialKernel::RadialKernel(const Optics& optics, Model model, Scaling scaling, float piece_radius) {
    integrate(optics, model);
    const glm::dvec3 all = within_.back();
    returned_ = glm::vec3(all);
    const glm::dvec3 scale = scaling == Scaling::exact ? 1.0 / glm::max(all, glm::dvec3(1e-12)) : glm::dvec3(1.0);
    for (glm::dvec3& share : within_) share *= scale;
    own_ = glm::vec3(within(double(piece_radius)));
    const float low = 0.0625f * piece_radius * piece_radius;
    low_bits_ = std::bit_cast<uint32_t>(low) >> kFractionBits << kFractionBits;
    table_.resize(kEntries);
    const glm::vec3 extinction = optics.sigma_s_reduced + optics.sigma_a;
    const double path = 3.0 / double(extinction.x + extinction.y + extinction.z);
    for (uint32_t i = 0; i < kEntries; ++i) {
        const double r = std::sqrt(double(std::bit_cast<float>(low_bits_ + (i << kFractionBits))));
        const glm::dvec3 value = r > 8.0 * double(piece_radius) ? scale * glm::dvec3(exitance(model, optics, float(r)))
                                                                : mean_over_disc(r, double(piece_radius));
        const double deep = 1.0 - std::exp(-r / (kDeepPaths * path));
        table_[i] = glm::vec4(glm::vec3(value), deep * glm::dot(value, glm::dvec3(0.2126, 0.7152, 0.0722)));
    }
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
glm::dvec3 RadialKernel::mean_over_disc(double r, double radius) const {
    constexpr int kRings = 96;
    glm::dvec3 sum = r < radius ? within(radius - r) : glm::dvec3(0.0);
    const double low = std::abs(r - radius), high = r + radius;
    glm::dvec3 before = within(low);
    for (int i = 0; i < kRings; ++i) {
        const double outer = low + (high - low) * (i + 1.0) / kRings, middle = low + (high - low) * (i + 0.5) / kRings;
        const glm::dvec3 now = within(outer);
        const double cosine = (middle * middle + r * r - radius * radius) / (2.0 * middle * r);
        sum += (now - before) * (std::acos(std::clamp(cosine, -1.0, 1.0)) / std::numbers::pi);
        before = now;
    }
    return sum / (std::numbers::pi * radius * radius);
}

glm::vec3 RadialKernel::at(float r) const {
    const auto bits = int64_t(std::bit_cast<uint32_t>(r * r)) - int64_t(low_bits_);
    const int64_t most = (int64_t(kEntries - 1) << kFractionBits) - 1;
    const auto place = uint32_t(std::clamp<int64_t>(bits, 0, most));
    const uint32_t i = place >> kFractionBits;
    const float f = float(place & ((1u << kFractionBits) - 1u)) / float(1u << kFractionBits);
    return glm::vec3(glm::mix(table_[i], table_[i + 1], f));
}

}  // namespace tyndall::translucency
