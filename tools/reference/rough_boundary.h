#pragma once
/// A rough boundary between two clear media: microfacets with Smith's shadowing and Fresnel, and all bounces between
/// them, by a random walk along the microsurface (Heitz et al., "Multiple-Scattering Microfacet BSDFs with the Smith
/// Model", 2016). It loses no light at any roughness and index.

#include "reference/sampler.h"
#include "reference/standard_bsdf.h"

namespace tyndall::reference {

/// Boundaries less rough than this are smooth.
inline constexpr float kSmoothRoughness = 0.03f;

/// Directions point away from the boundary, `v` to where the path comes from, on the side of the normal. Radiance is
/// carried from `l` to `v`: crossing scales it by (n_here / n_beyond)^2.
class RoughBoundary {
 public:
    /// `eta` = n_beyond / n_here, here being the side of `v`. The sampler must outlive this.
    RoughBoundary(const glm::vec3& n, const glm::vec3& v, float eta, float roughness, Sampler& sampler);

    /// Unbiased estimate of f |cos(l)|, 1/sr. `pdf` weighs it against other strategies: near the density of `sample`.
    [[nodiscard]] float evaluate(const glm::vec3& l, float& pdf) const;
    /// Follows light through the microsurface; `pdf` as for evaluate.
    [[nodiscard]] bool sample(BsdfSample& out) const;

 private:
    /// Where a walk is: its direction (local, normal = z), height, and whether it is on the side of `v`.
    struct Walk {
        glm::vec3 direction{0.0f};
        float height = 0.0f;
        bool here = true;
    };
    bool fly(Walk& walk) const;
    void bounce(Walk& walk) const;
    [[nodiscard]] float phase(const Walk& walk, const glm::vec3& l) const;
    [[nodiscard]] float single_pdf(const glm::vec3& l) const;
    [[nodiscard]] float visible_normals(const glm::vec3& w, const glm::vec3& h) const;
    [[nodiscard]] float lambda(const glm::vec3& w) const;
    [[nodiscard]] float escape(const glm::vec3& w, float height) const;
    [[nodiscard]] glm::vec3 sample_normal(const glm::vec3& w) const;
    [[nodiscard]] glm::vec3 local(const glm::vec3& w) const {
        return {glm::dot(w, t_), glm::dot(w, b_), glm::dot(w, n_)};
    }

    glm::vec3 n_, t_, b_, v_;  ///< v_ is local
    float eta_, alpha_;
    Sampler& sampler_;
};

}  // namespace tyndall::reference
