#pragma once
/// How much light a half-space of a scattering solid gives back, exactly.

#include <array>
#include <glm/vec3.hpp>

namespace tyndall::physics {

/// For each channel, the share of light that has entered a half-space (isotropic scattering, smooth boundary) and
/// leaves it again, by the cosine inside at which it entered. What the boundary mirrors before does not count.
///
/// Chandrasekhar's law of diffuse reflection (Radiative Transfer, 1960, par. 38) for what the solid returns to the
/// boundary from inside, and Fresnel's equations for what the boundary returns to the solid; solved as a linear system
/// on Gauss points. Within 0.002 of photons traced through the solid. Anisotropic phase functions by the similarity of
/// reduced coefficients.
class HalfSpace {
 public:
    static constexpr int kCosines = 16;  ///< evenly from 0 to 1

    /// `albedo` is the reduced one, 0..1 a channel; `eta` the index of refraction inside over the one outside, >= 1.
    HalfSpace(const glm::vec3& albedo, float eta);

    /// Share that leaves, linear between the table's cosines.
    [[nodiscard]] glm::vec3 leaving(float cosine_inside) const;
    /// Of uniform light from all of the outside: what leaves after having entered, over all that arrived.
    [[nodiscard]] const glm::vec3& diffuse_albedo() const { return diffuse_albedo_; }
    /// Of the diffuse light that enters, the share that leaves.
    [[nodiscard]] const glm::vec3& diffuse_leaving() const { return diffuse_leaving_; }
    [[nodiscard]] const std::array<glm::vec3, kCosines>& table() const { return table_; }
    /// How light that comes up from deep inside is spread over directions inside, over the mean that leaves: Milne's
    /// problem. Darker toward the limb, as the sun is. At the table's cosines.
    [[nodiscard]] const std::array<glm::vec3, kCosines>& deep() const { return deep_; }

 private:
    void add_channel(int channel, double albedo, float eta);

    std::array<glm::vec3, kCosines> table_{};
    std::array<glm::vec3, kCosines> deep_{};
    glm::vec3 diffuse_albedo_{0.0f};
    glm::vec3 diffuse_leaving_{0.0f};
};

}  // namespace tyndall::physics
