#pragma once
/// Photons traced through layers of a solid, to hold models of diffusion against.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <span>
#include <vector>

#include "physics/multipole.h"
#include "physics/physics.h"

namespace tyndall::physics {

/// What became of photons that entered along the normal; shares of them.
struct PhotonCount {
    double reflected = 0.0, transmitted = 0.0, absorbed = 0.0;
    std::vector<std::pair<double, double>> exits;  ///< where on top: distance from a line through the entrance, weight

    /// What is seen `x` metres inside of the edge of a lit half plane.
    [[nodiscard]] double edge(double x) const {
        double all = 0.0, near = 0.0;
        for (const auto& [distance, weight] : exits) {
            all += weight;
            if (distance < std::abs(x)) near += weight;
        }
        return 0.5 + std::copysign(0.5 * near / all, x);
    }
    /// From where 10 % is seen to where 90 % is, m.
    [[nodiscard]] double edge_width() {
        std::ranges::sort(exits);
        double all = 0.0, near = 0.0;
        for (const auto& exit : exits) all += exit.second;
        for (const auto& [distance, weight] : exits)
            if ((near += weight) >= 0.8 * all) return 2.0 * distance;
        return 0.0;
    }
};

/// Isotropic scattering, smooth boundaries toward the outside, none between layers.
class PhotonTrace {
 public:
    PhotonTrace(std::span<const SolidLayer> layers, int channel, unsigned seed) : engine_(seed) {
        for (const SolidLayer& layer : layers) {
            const double scattering = layer.sigma_s_reduced[channel], all = scattering + layer.sigma_a[channel];
            layers_.push_back({bottom_, bottom_ += layer.thickness_m, all, scattering / all});
        }
        eta_[0] = layers.front().eta;
        eta_[1] = layers.back().eta;
    }

    [[nodiscard]] PhotonCount run(int photons) {
        PhotonCount count;
        for (int i = 0; i < photons; ++i) follow(count);
        count.reflected /= photons;
        count.transmitted /= photons;
        count.absorbed /= photons;
        return count;
    }

 private:
    struct Layer {
        double top, bottom, extinction, albedo;
    };

    double random() { return double(engine_() >> 11) * 0x1p-53; }

    void follow(PhotonCount& count) {
        dvec3 at(0.0), way(0.0, 0.0, 1.0);
        size_t here = 0;
        for (double weight = 1.0;;) {
            if (!fly(at, way, here)) {
                (way.z > 0.0 ? count.transmitted : count.reflected) += weight;
                if (way.z < 0.0) count.exits.emplace_back(std::abs(at.x), weight);
                return;
            }
            count.absorbed += weight * (1.0 - layers_[here].albedo);
            weight *= layers_[here].albedo;
            if (weight < 0.05 && random() > 0.2) return;
            if (weight < 0.05) weight *= 5.0;
            const double z = 2.0 * random() - 1.0, angle = 2.0 * std::numbers::pi * random(),
                         s = std::sqrt(1.0 - z * z);
            way = {s * std::cos(angle), s * std::sin(angle), z};
        }
    }
    /// To the next collision; false where it leaves before.
    bool fly(dvec3& at, dvec3& way, size_t& here) {
        for (double depth = -std::log(1.0 - random());;) {
            const Layer& layer = layers_[here];
            const double border = way.z > 0.0 ? layer.bottom : layer.top, far = (border - at.z) / way.z;
            if (depth < far * layer.extinction) {
                at += way * (depth / layer.extinction);
                return true;
            }
            depth -= far * layer.extinction;
            at = {at.x + far * way.x, at.y + far * way.y, border};
            const bool out = way.z > 0.0 ? here + 1 == layers_.size() : here == 0;
            if (!out) {
                here += way.z > 0.0 ? 1 : size_t(-1);
                continue;
            }
            const double eta = eta_[way.z > 0.0 ? 1 : 0];
            const float mirrored = fresnel_dielectric(float(std::abs(way.z)), float(1.0 / eta));
            if (eta == 1.0 || random() >= double(mirrored)) return false;
            way.z = -way.z;
        }
    }

    std::mt19937_64 engine_;
    std::vector<Layer> layers_;
    double bottom_ = 0.0, eta_[2] = {1.0, 1.0};
};

}  // namespace tyndall::physics
