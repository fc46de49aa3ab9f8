#include "physics/multipole.h"

#include <algorithm>
#include <cmath>

#include "physics/physics.h"

namespace tyndall::physics {
namespace {

/// A channel of a layer alone.
struct Slab {
    double thickness = 0.0, sigma_a = 0.0, sigma_s = 0.0;
    double above = 1.0, below = 1.0;  ///< A of its boundaries
};

struct Sides {
    double reflected = 0.0, transmitted = 0.0;
};

/// Sums over the images, each of which sends exp(-q distance) / 2 through a plane.
Sides lit_from_above(const Slab& slab, double k) {
    const double sigma_t = slab.sigma_a + slab.sigma_s, coefficient = 1.0 / (3.0 * sigma_t);
    const double q = std::max(std::sqrt(3.0 * slab.sigma_a * sigma_t + k * k), 1e-6 * sigma_t);
    const double d = std::min(slab.thickness, 60.0 / q + 60.0 / sigma_t);
    const double source = std::min(1.0 / sigma_t, 0.5 * d), mirrored = source + 4.0 * slab.above * coefficient;
    const double period = 2.0 * (d + 2.0 * coefficient * (slab.above + slab.below));
    const auto e = [q](double distance) { return std::exp(-q * distance); };
    // of the flux through the top and the bottom: images at i period + source and i period - mirrored
    const double scale = 0.5 * (slab.sigma_s / sigma_t) / -std::expm1(-q * period);
    return {scale * (e(source) - e(period - source) + e(mirrored) - e(period - mirrored)),
            scale * (e(d - source) - e(period - d + source) - e(d + mirrored) + e(period - d - mirrored))};
}

Sides channel_response(std::span<const SolidLayer> layers, int channel, double k) {
    Sides above, below;  // what is put together so far, lit from either side; below.transmitted leads up
    for (size_t i = 0; i < layers.size(); ++i) {
        const SolidLayer& layer = layers[i];
        const double before = i > 0 ? layers[i - 1].eta : 1.0, after = i + 1 < layers.size() ? layers[i + 1].eta : 1.0;
        Slab slab{layer.thickness_m, layer.sigma_a[channel], layer.sigma_s_reduced[channel],
                  boundary_parameter(layer.eta / before), boundary_parameter(layer.eta / after)};
        const Sides down = lit_from_above(slab, k);
        std::swap(slab.above, slab.below);
        const Sides up = lit_from_above(slab, k);
        if (i == 0) {
            above = down;
            below = up;
            continue;
        }
        const double between = 1.0 / std::max(1.0 - below.reflected * down.reflected, 1e-9);
        const Sides both{above.reflected + above.transmitted * down.reflected * below.transmitted * between,
                         above.transmitted * down.transmitted * between};
        below = {up.reflected + up.transmitted * below.reflected * down.transmitted * between,
                 up.transmitted * below.transmitted * between};
        above = both;
    }
    return above;
}

}  // namespace

double boundary_parameter(double eta) {
    if (eta == 1.0) return 1.0;  // the fit of Fdr has 0.002 there
    const double f = double(fresnel_diffuse_reflectance(float(eta)));
    return (1.0 + f) / (1.0 - f);
}

SolidResponse multipole_response(std::span<const SolidLayer> layers, double k) {
    SolidResponse response;
    for (int c = 0; c < 3; ++c) {
        const Sides sides = channel_response(layers, c, k);
        response.reflected[c] = sides.reflected;
        response.transmitted[c] = sides.transmitted;
    }
    return response;
}

}  // namespace tyndall::physics
