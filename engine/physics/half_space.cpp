#include "physics/half_space.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "physics/physics.h"

namespace tyndall::physics {
namespace {

/// A quadrature over cosines 0..1.
struct Nodes {
    std::vector<double> cosine, weight;

    [[nodiscard]] size_t size() const { return cosine.size(); }
    /// Gauss's rule with `count` points between two cosines: Newton's iteration on Legendre's polynomial.
    void add(double low, double high, int count) {
        for (int i = 0; i < count; ++i) {
            double x = std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5)), slope = 1.0;
            for (int step = 0; step < 50; ++step) {
                double p = 1.0, before = 0.0;
                for (int n = 1; n <= count; ++n) {
                    const double next = ((2.0 * n - 1.0) * x * p - (n - 1.0) * before) / n;
                    before = p;
                    p = next;
                }
                slope = count * (x * p - before) / (x * x - 1.0);
                x -= p / slope;
            }
            cosine.push_back(low + 0.5 * (high - low) * (1.0 + x));
            weight.push_back((high - low) / ((1.0 - x * x) * slope * slope));
        }
    }
};

constexpr int kHalf = 12;  ///< points on either side of the critical angle

double from_inside(double cosine, float eta) {
    return double(fresnel_dielectric(float(cosine), 1.0f / eta));
}

/// Chandrasekhar's H at the nodes: 1/H(m) = sqrt(1 - a) + a/2 sum w n H(n) / (m + n).
std::vector<double> h_function(double albedo, const Nodes& nodes) {
    std::vector<double> h(nodes.size(), 1.0), next(nodes.size());
    const double root = std::sqrt(1.0 - albedo);
    for (int round = 0; round < 200; ++round) {
        for (size_t i = 0; i < nodes.size(); ++i) {
            double sum = 0.0;
            for (size_t j = 0; j < nodes.size(); ++j)
                sum += nodes.weight[j] * nodes.cosine[j] * h[j] / (nodes.cosine[i] + nodes.cosine[j]);
            next[i] = 0.5 * (h[i] + 1.0 / (root + 0.5 * albedo * sum));
        }
        h.swap(next);
    }
    return h;
}

double h_at(double albedo, const Nodes& nodes, const std::vector<double>& h, double cosine) {
    double sum = 0.0;
    for (size_t j = 0; j < nodes.size(); ++j)
        sum += nodes.weight[j] * nodes.cosine[j] * h[j] / (cosine + nodes.cosine[j]);
    return 1.0 / (std::sqrt(1.0 - albedo) + 0.5 * albedo * sum);
}

/// Gauss-Jordan with pivots: a x = b, in place.
void solve(std::vector<std::vector<double>>& a, std::vector<double>& b) {
    const size_t n = b.size();
    for (size_t k = 0; k < n; ++k) {
        size_t pivot = k;
        for (size_t i = k + 1; i < n; ++i)
            if (std::abs(a[i][k]) > std::abs(a[pivot][k])) pivot = i;
        std::swap(a[k], a[pivot]);
        std::swap(b[k], b[pivot]);
        for (size_t i = 0; i < n; ++i) {
            if (i == k) continue;
            const double factor = a[i][k] / a[k][k];
            for (size_t j = k; j < n; ++j) a[i][j] -= factor * a[k][j];
            b[i] -= factor * b[k];
        }
    }
    for (size_t k = 0; k < n; ++k) b[k] /= a[k][k];
}

/// One channel's half-space: what light that goes in at a cosine inside comes to.
class Solid {
 public:
    Solid(double albedo, float eta) : albedo_(albedo), eta_(eta) {
        const double critical = std::sqrt(std::max(0.0, 1.0 - 1.0 / (double(eta) * double(eta))));
        if (critical > 1e-3) nodes_.add(0.0, critical, kHalf);
        nodes_.add(critical > 1e-3 ? critical : 0.0, 1.0, kHalf);
        h_ = h_function(albedo_, nodes_);
        for (const double cosine : nodes_.cosine) mirrored_.push_back(from_inside(cosine, eta_));
        rate_ = decay(albedo_);
        std::vector<double> out(nodes_.size(), 0.0), down;
        for (size_t j = 0; j < nodes_.size(); ++j)
            for (size_t i = 0; i < nodes_.size(); ++i)
                out[j] += back(i, nodes_.cosine[j], h_[j]) * (1.0 - mirrored_[i]);
        for (size_t j = 0; j < nodes_.size(); ++j) down.push_back(sinks(nodes_.cosine[j], h_[j]));
        leaves_ = closed(std::move(out));
        sinks_ = closed(std::move(down));
    }

    /// The share that leaves.
    [[nodiscard]] double leaving(double cosine) const {
        const double h = h_at(albedo_, nodes_, h_, cosine);
        double sum = 0.0;
        for (size_t i = 0; i < nodes_.size(); ++i)
            sum += back(i, cosine, h) * (1.0 - mirrored_[i] + mirrored_[i] * leaves_[i]);
        return sum;
    }
    /// What reaches the depth, over some constant: by reciprocity how light from there leaves.
    [[nodiscard]] double sinking(double cosine) const {
        const double h = h_at(albedo_, nodes_, h_, cosine);
        double sum = sinks(cosine, h);
        for (size_t i = 0; i < nodes_.size(); ++i) sum += back(i, cosine, h) * mirrored_[i] * sinks_[i];
        return sum;
    }

 private:
    /// A unit of flux that goes in at a cosine, where H is `h`, comes back to the boundary as flux at node i.
    [[nodiscard]] double back(size_t i, double cosine, double h) const {
        return 0.5 * albedo_ * h_[i] * h / (nodes_.cosine[i] + cosine) * nodes_.cosine[i] * nodes_.weight[i];
    }
    /// What never comes back: Chandrasekhar's (1960, par. 87) law of darkening of deep light.
    [[nodiscard]] double sinks(double cosine, double h) const { return h / (1.0 - rate_ * cosine); }
    /// x(j) = b(j) + sum_i back(i, j) mirrored(i) x(i).
    [[nodiscard]] std::vector<double> closed(std::vector<double> b) const {
        std::vector<std::vector<double>> a(b.size(), std::vector<double>(b.size()));
        for (size_t j = 0; j < b.size(); ++j)
            for (size_t i = 0; i < b.size(); ++i)
                a[j][i] = (i == j ? 1.0 : 0.0) - back(i, nodes_.cosine[j], h_[j]) * mirrored_[i];
        solve(a, b);
        return b;
    }
    /// The slowest decay with depth, over the extinction: a / (2 k) log((1 + k) / (1 - k)) = 1. Not above kFastest:
    /// where next to nothing is scattered light from the depth would be a single ray.
    [[nodiscard]] static double decay(double albedo) {
        constexpr double kFastest = 0.9;
        double low = 0.0, high = kFastest;
        for (int step = 0; step < 60; ++step) {
            const double k = 0.5 * (low + high);
            (albedo * std::atanh(k) < k ? low : high) = k;
        }
        return low;
    }

    double albedo_;
    float eta_;
    double rate_ = 0.0;
    Nodes nodes_;
    std::vector<double> h_, mirrored_, leaves_, sinks_;
};

}  // namespace

HalfSpace::HalfSpace(const glm::vec3& albedo, float eta) {
    for (int channel = 0; channel < 3; ++channel)
        add_channel(channel, std::clamp(double(albedo[channel]), 0.0, 1.0 - 1e-7), std::max(eta, 1.0f));
}

void HalfSpace::add_channel(int channel, double albedo, float eta) {
    const Solid solid(albedo, eta);
    Nodes outside;
    outside.add(0.0, 1.0, kHalf);
    double entered = 0.0, left = 0.0, deep = 0.0;
    for (size_t i = 0; i < outside.size(); ++i) {
        const double c = outside.cosine[i];
        const double inside = std::sqrt(1.0 - (1.0 - c * c) / (double(eta) * double(eta)));
        const double share = 2.0 * c * outside.weight[i] * (1.0 - double(fresnel_dielectric(float(c), eta)));
        entered += share;
        left += share * solid.leaving(inside);
        deep += share * solid.sinking(inside);
    }
    diffuse_albedo_[channel] = float(left);
    diffuse_leaving_[channel] = float(left / entered);
    for (size_t i = 0; i < kCosines; ++i) {
        const double cosine = double(i) / double(kCosines - 1);
        table_[i][channel] = float(solid.leaving(cosine));
        deep_[i][channel] = float(solid.sinking(cosine) * entered / deep);
    }
}

glm::vec3 HalfSpace::leaving(float cosine_inside) const {
    const float x = std::clamp(cosine_inside, 0.0f, 1.0f) * float(kCosines - 1);
    const size_t i = std::min(size_t(x), size_t(kCosines - 2));
    return glm::mix(table_[i], table_[i + 1], x - float(i));
}

}  // namespace tyndall::physics
