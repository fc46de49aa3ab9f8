#pragma once
/// A profile of diffusion that is a function of the distance, as a table of what it sums up to.

#include <functional>
#include <glm/vec3.hpp>
#include <vector>

namespace tyndall::physics {

/// Light that leaves a unit of area `r` metres from where a unit of flux has entered, a channel each; 1/m2.
using RadialFunction = std::function<glm::dvec3(double r)>;

/// A radial function as rings in equal steps of log r: from 0.1 um to 10 m, so that no length need be known before.
class RadialProfile {
 public:
    struct Ring {
        double r = 0.0;            ///< in its middle, m
        glm::dvec3 exitance{0.0};  ///< there, over `total`; 1/m2
        glm::dvec3 share{0.0};     ///< of the light that leaves in the ring
    };

    /// Negative values and what is not a number count as 0.
    explicit RadialProfile(const RadialFunction& exitance);

    /// Integral over the plane: the diffuse albedo for light that has entered.
    [[nodiscard]] const glm::dvec3& total() const { return total_; }
    [[nodiscard]] const std::vector<Ring>& rings() const { return rings_; }
    /// A ring's width over its radius.
    [[nodiscard]] static double step();
    /// Share of the light that leaves `x` metres inside of the straight edge of a lit half plane.
    [[nodiscard]] glm::dvec3 edge(double x) const;
    /// The distance within which `share` of a channel's light leaves, m.
    [[nodiscard]] double distance(double share, int channel) const;
    /// Mean of the distance, m.
    [[nodiscard]] glm::dvec3 mean_distance() const;

 private:
    std::vector<Ring> rings_;
    glm::dvec3 total_{0.0};
};

/// How far a lit edge is spread: from where 10 % of the light is seen to where 90 % is, m.
[[nodiscard]] double edge_width(const std::function<double(double x)>& edge);

}  // namespace tyndall::physics
