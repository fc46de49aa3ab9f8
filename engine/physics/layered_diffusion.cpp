#include "physics/layered_diffusion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "physics/hankel.h"
#include "physics/physics.h"

namespace tyndall::physics {
namespace {

enum class Theory { classical, grosjean };

/// D phi' = slope phi + offset: what all that lies below a depth demands of the fluence phi there.
struct Demand {
    double slope = 0.0, offset = 0.0;
};

/// A channel of a layer whose fluence is a exp(-q z) + b exp(-q (d - z)) + p exp(-sigma_t z), b = rho exp(-q d) a +
/// beta.
struct DiffusingLayer {
    double q = 0.0, d = 0.0, diffusion = 0.0, sigma_t = 0.0;
    double fade = 0.0, beam = 0.0;  ///< exp(-q d), exp(-sigma_t d)
    double p = 0.0, rho = 0.0, beta = 0.0;

    /// `entering` of the beam reaches the layer.
    DiffusingLayer(const SolidLayer& layer, int channel, double k, double entering, Theory theory) {
        const double sigma_a = layer.sigma_a[channel], sigma_s = layer.sigma_s_reduced[channel];
        sigma_t = std::max(sigma_s + sigma_a, 1e-6);
        // Grosjean's sources are what is scattered a second time
        const double albedo = theory == Theory::grosjean ? sigma_s / sigma_t : 1.0;
        diffusion = (2.0 - albedo) / (3.0 * sigma_t);
        q = std::max(std::sqrt(sigma_a / diffusion + k * k), 1e-6 * sigma_t);
        if (std::abs(q - sigma_t) < 1e-5 * sigma_t) q = sigma_t * (1.0 + 1e-5);  // where p is 0/0
        d = std::min(layer.thickness_m, 60.0 / q + 60.0 / sigma_t);
        fade = std::exp(-q * d);
        beam = std::exp(-sigma_t * d);
        p = albedo * sigma_s * entering / (diffusion * (q - sigma_t) * (q + sigma_t));
    }

    /// What is demanded at the layer's top, given what is demanded at its bottom.
    Demand pass_up(const Demand& below) {
        const double conductance = diffusion * q;
        rho = (conductance + below.slope) / (conductance - below.slope);
        beta = (p * beam * (diffusion * sigma_t + below.slope) + below.offset) / (conductance - below.slope);
        const double ratio = (1.0 - rho * fade * fade) / (1.0 + rho * fade * fade);
        return {-conductance * ratio,
                conductance * ((beta * fade + p) * ratio + beta * fade) - diffusion * sigma_t * p};
    }
    /// The fluence at its bottom, given that at its top.
    [[nodiscard]] double pass_down(double fluence) const {
        const double a = (fluence - beta * fade - p) / (1.0 + rho * fade * fade);
        return a * fade * (1.0 + rho) + beta + p * beam;
    }
};

/// The partial current condition phi = resistance D phi', and what passes outward for a fluence.
struct Boundary {
    double resistance = 0.0, passed = 0.0;

    Boundary(double eta, Theory theory) {
        if (theory == Theory::classical) {
            resistance = 2.0 * boundary_parameter(eta);
            passed = 1.0 / resistance;
            return;
        }
        const Diffusion moments = make_diffusion(vec3(1.0f), vec3(0.0f), 0.0f, float(eta));
        resistance = double((1.0f - moments.c_e) / moments.c_phi);
        passed = double(moments.c_phi) + double(moments.c_e) / resistance;
    }
};

SolidResponse respond(std::span<const SolidLayer> layers, double k, Theory theory) {
    SolidResponse response;
    const Boundary above(layers.front().eta, theory), below(layers.back().eta, theory);
    std::vector<DiffusingLayer> stack;
    stack.reserve(layers.size());
    for (int c = 0; c < 3; ++c) {
        stack.clear();
        double beam = 1.0;
        for (const SolidLayer& layer : layers) {
            stack.emplace_back(layer, c, k, beam, theory);
            beam *= stack.back().beam;
        }
        Demand demand{-1.0 / below.resistance, 0.0};
        for (size_t i = stack.size(); i-- > 0;) demand = stack[i].pass_up(demand);
        double fluence = above.resistance * demand.offset / (1.0 - above.resistance * demand.slope);
        response.reflected[c] = std::max(above.passed * fluence, 0.0);  // rounding
        for (const DiffusingLayer& layer : stack) fluence = layer.pass_down(fluence);
        response.transmitted[c] = std::max(below.passed * fluence, 0.0) + beam;
    }
    return response;
}

/// Optical depth of `z` metres along the normal, and the scattering there; none below the layers.
struct Depth {
    glm::dvec3 optical{0.0}, scattering{0.0};

    Depth(std::span<const SolidLayer> layers, double z) {
        for (const SolidLayer& layer : layers) {
            optical += std::min(z, layer.thickness_m) * (layer.sigma_a + layer.sigma_s_reduced);
            z -= layer.thickness_m;
            if (z > 0.0) continue;
            scattering = layer.sigma_s_reduced;
            return;
        }
    }
};

}  // namespace

SolidResponse layered_response(std::span<const SolidLayer> layers, double k) {
    return respond(layers, k, Theory::classical);
}

/// In equal steps of the depth's logarithm, from where it is short against everything.
glm::dvec3 once_scattered(std::span<const SolidLayer> layers, double r) {
    constexpr int kSteps = 120;
    const glm::dvec3 first = layers.front().sigma_a + layers.front().sigma_s_reduced;
    const double path = 1.0 / std::max({first.x, first.y, first.z, 1e-6});
    const double low = std::log(1e-3 * std::min(r, path)), step = (std::log(1e3 * path) - low) / kSteps;
    glm::dvec3 sum(0.0);
    for (int i = 0; i < kSteps; ++i) {
        const double z = std::exp(low + (i + 0.5) * step), distance2 = r * r + z * z, cosine = z / std::sqrt(distance2);
        const Depth depth(layers, z);
        const double passed = 1.0 - double(fresnel_dielectric(float(cosine), float(1.0 / layers.front().eta)));
        sum += depth.scattering * glm::exp(-depth.optical * (1.0 + 1.0 / cosine)) * (passed * cosine * z / distance2);
    }
    return sum * (step / (4.0 * std::numbers::pi));
}

RadialFunction solid_exitance(std::vector<SolidLayer> layers) {
    constexpr int kBeamSources = 64;
    if (layers.size() == 1 && std::isinf(layers.front().thickness_m)) {
        const Diffusion m = make_diffusion(vec3(layers.front().sigma_s_reduced), vec3(layers.front().sigma_a), 0.0f,
                                           float(layers.front().eta));
        return [m, layers = std::move(layers)](double r) {
            return glm::dvec3(photon_beam_diffusion(m, float(r), kBeamSources)) + once_scattered(layers, r);
        };
    }
    return [layers = std::move(layers)](double r) {
        return inverse_hankel([&](double k) { return respond(layers, k, Theory::grosjean).reflected; }, r) +
               once_scattered(layers, r);
    };
}

}  // namespace tyndall::physics
