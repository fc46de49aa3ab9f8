#pragma once
/// A rough boundary between two clear media (Walter et al., "Microfacet Models for Refraction through Rough Surfaces",
/// 2007), single bounces on the microfacets only: what bounces again between them is lost. That loss is 1 % at
/// roughness 0.4 and grows to some 10 % at roughness 1 for index 1.5.

#include <cmath>

#include "physics/physics.h"
#include "reference/standard_bsdf.h"

namespace tyndall::reference {

/// Boundaries less rough than this are smooth.
inline constexpr float kSmoothRoughness = 0.03f;

/// Directions point away from the boundary, `v` to where the path comes from, on the side of the normal. Radiance is
/// carried from `l` to `v`: crossing it scales by (n_here / n_beyond)^2.
class DielectricBsdf {
 public:
    /// `eta` = n_beyond / n_here, here being the side of `v`.
    DielectricBsdf(const glm::vec3& n, const glm::vec3& v, float eta, float roughness)
        : n_(n), v_(v), eta_(eta), alpha_(physics::ggx_alpha(roughness)), nov_(glm::max(glm::dot(n, v), 1e-4f)) {}

    /// f |cos(l)|, 1/sr.
    [[nodiscard]] float evaluate(const glm::vec3& l, float& pdf) const {
        const float nol = glm::dot(n_, l);
        pdf = 0.0f;
        if (nol == 0.0f) return 0.0f;
        const bool reflects = nol > 0.0f;
        glm::vec3 h = reflects ? v_ + l : -(v_ + eta_ * l);
        const float length = glm::length(h);
        if (!(length > 0.0f)) return 0.0f;
        h /= length;
        if (glm::dot(n_, h) < 0.0f) h = -h;
        const float voh = glm::dot(v_, h), loh = glm::dot(l, h);
        if (voh <= 0.0f || (reflects ? loh <= 0.0f : loh >= 0.0f)) return 0.0f;
        const float fresnel = physics::fresnel_dielectric(voh, eta_);
        const float lambda_v = physics::ggx_lambda(nov_, alpha_), lambda_l = physics::ggx_lambda(std::abs(nol), alpha_);
        const float visible = physics::ggx_distribution(n_, h, alpha_) * voh / (nov_ * (1.0f + lambda_v));  // of h
        const float masking = (1.0f + lambda_v) / (1.0f + lambda_v + lambda_l);                             // G2 / G1
        if (reflects) {
            pdf = fresnel * visible / (4.0f * voh);
            return pdf * masking;
        }
        const float root = voh + eta_ * loh;
        pdf = (1.0f - fresnel) * visible * eta_ * eta_ * std::abs(loh) / (root * root);
        return pdf * masking / (eta_ * eta_);
    }

    [[nodiscard]] bool sample(float choice, glm::vec2 xi, BsdfSample& out) const {
        glm::vec3 t, b;
        physics::orthonormal_basis(n_, t, b);
        const glm::vec3 local = physics::sample_ggx_visible_normal(
            xi, glm::normalize(glm::vec3(glm::dot(v_, t), glm::dot(v_, b), nov_)), alpha_);
        const glm::vec3 h = t * local.x + b * local.y + n_ * local.z;
        const float voh = glm::dot(v_, h);
        if (voh <= 0.0f) return false;
        if (choice < physics::fresnel_dielectric(voh, eta_))
            out.direction = glm::normalize(2.0f * voh * h - v_);
        else if (!physics::refract_ray(-v_, h, 1.0f / eta_, out.direction))
            return false;
        const float value = evaluate(out.direction, out.pdf);
        if (!(out.pdf > 0.0f)) return false;
        out.weight = glm::vec3(value / out.pdf);
        return true;
    }

 private:
    glm::vec3 n_, v_;
    float eta_, alpha_, nov_;
};

}  // namespace tyndall::reference
