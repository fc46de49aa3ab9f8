#include "reference/rough_boundary.h"

#include <cmath>
#include <limits>

namespace tyndall::reference {
namespace {

using glm::vec3;

constexpr int kMostBounces = 256;
constexpr float kEvenShare = 0.05f;  ///< of the weighing density: what several bounces add may come from anywhere

// Heights of the microsurface are spread evenly over [-1, 1].
float below(float height) {
    return glm::clamp(0.5f * (height + 1.0f), 0.0f, 1.0f);
}
float height_above(float share) {
    return share > 0.0f ? glm::min(2.0f * share - 1.0f, 1.0f) : -1.0f;  // 0 / 0 is at the bottom, too
}

}  // namespace

RoughBoundary::RoughBoundary(const vec3& n, const vec3& v, float eta, float roughness, Sampler& sampler)
    : n_(n), eta_(eta), alpha_(physics::ggx_alpha(roughness)), sampler_(sampler) {
    physics::orthonormal_basis(n_, t_, b_);
    v_ = local(v);
    v_.z = glm::max(v_.z, 1e-4f);
    v_ = glm::normalize(v_);
}

float RoughBoundary::lambda(const vec3& w) const {
    const float sine2 = 1.0f - w.z * w.z;
    if (sine2 < 1e-9f) return w.z > 0.0f ? 0.0f : -1.0f;
    const float root = std::sqrt(1.0f + alpha_ * alpha_ * sine2 / (w.z * w.z));
    return 0.5f * ((w.z > 0.0f ? root : -root) - 1.0f);
}

/// Probability that a ray going up from a height meets nothing.
float RoughBoundary::escape(const vec3& w, float height) const {
    if (w.z <= 0.0f) return 0.0f;
    return std::pow(below(height), lambda(w));
}

/// Moves the walk to where it meets the microsurface; false when it gets away.
bool RoughBoundary::fly(Walk& walk) const {
    // beyond the boundary the same surface is seen from below, upside down
    const vec3 w = walk.here ? walk.direction : -walk.direction;
    const float height = walk.here ? walk.height : -walk.height, xi = sampler_.next_independent();
    float met = height;
    if (w.z > 0.9999f) return false;
    if (w.z < -0.9999f) {
        met = height_above(xi * below(height));
    } else if (std::abs(w.z) >= 1e-4f) {
        if (xi >= 1.0f - escape(w, height)) return false;
        met = height_above(below(height) / std::pow(1.0f - xi, 1.0f / lambda(w)));
    }
    walk.height = walk.here ? met : -met;
    return true;
}

/// Dupuy & Benyoub, "Sampling Visible GGX Normals with Spherical Caps", 2023; w may point below the horizon.
vec3 RoughBoundary::sample_normal(const vec3& w) const {
    const vec3 stretched = glm::normalize(vec3(alpha_ * w.x, alpha_ * w.y, w.z));
    const float azimuth = physics::kTwoPi * sampler_.next_independent();
    const float z = (1.0f - sampler_.next_independent()) * (1.0f + stretched.z) - stretched.z;
    const vec3 h = physics::spherical_direction(glm::clamp(z, -1.0f, 1.0f), azimuth) + stretched;
    return glm::normalize(vec3(alpha_ * h.x, alpha_ * h.y, glm::max(h.z, 1e-6f)));
}

void RoughBoundary::bounce(Walk& walk) const {
    const float flip = walk.here ? 1.0f : -1.0f, eta = walk.here ? eta_ : 1.0f / eta_;
    const vec3 back = -flip * walk.direction;  // seen from above the side it is on
    const vec3 h = sample_normal(back);
    const float cosine = glm::dot(back, h);
    vec3 out;
    if (sampler_.next_independent() >= physics::fresnel_dielectric(cosine, eta) &&
        physics::refract_ray(-back, h, 1.0f / eta, out))
        walk.here = !walk.here;
    else
        out = glm::normalize(2.0f * cosine * h - back);
    walk.direction = flip * out;
}

/// Density of the normals that `w` sees, 1/sr.
float RoughBoundary::visible_normals(const vec3& w, const vec3& h) const {
    if (h.z <= 0.0f) return 0.0f;
    const float area = 0.5f * (w.z + std::sqrt(w.z * w.z + (1.0f - w.z * w.z) * alpha_ * alpha_));
    if (!(area > 0.0f)) return 0.0f;
    return glm::max(0.0f, glm::dot(w, h)) * physics::ggx_distribution(vec3(0.0f, 0.0f, 1.0f), h, alpha_) / area;
}

/// Density with which a walk that meets the surface bounces toward `l`, 1/sr.
float RoughBoundary::phase(const Walk& walk, const vec3& l) const {
    const float flip = walk.here ? 1.0f : -1.0f, eta = walk.here ? eta_ : 1.0f / eta_;
    const vec3 back = -flip * walk.direction, out = flip * l;
    if ((l.z > 0.0f) == walk.here) {
        const vec3 h = glm::normalize(back + out);
        const float cosine = glm::dot(back, h);
        if (!(cosine > 0.0f)) return 0.0f;
        return 0.25f * visible_normals(back, h) / cosine * physics::fresnel_dielectric(cosine, eta);
    }
    vec3 h = -(back + eta * out);
    const float length = glm::length(h);
    if (!(length > 0.0f)) return 0.0f;
    h *= (h.z < 0.0f ? -1.0f : 1.0f) / length;
    const float cosine = glm::dot(back, h), beyond = -glm::dot(out, h);
    if (!(cosine > 0.0f) || !(beyond > 0.0f)) return 0.0f;
    const float root = cosine - eta * beyond;
    if (std::abs(root) < 1e-6f) return 0.0f;
    return eta * eta * (1.0f - physics::fresnel_dielectric(cosine, eta)) * visible_normals(back, h) * beyond /
           (root * root);
}

float RoughBoundary::single_pdf(const vec3& l) const {
    return (1.0f - kEvenShare) * phase({-v_, 0.0f, true}, l) + kEvenShare * physics::kInverseFourPi;
}

float RoughBoundary::evaluate(const vec3& direction, float& pdf) const {
    const vec3 l = local(direction);
    pdf = single_pdf(l);
    Walk walk{-v_, 2.0f, true};
    float value = 0.0f;
    for (int i = 0; i < kMostBounces && fly(walk); ++i) {
        const float away = l.z > 0.0f ? escape(l, walk.height) : escape(-l, -walk.height);
        value += phase(walk, l) * away;
        bounce(walk);
    }
    return l.z > 0.0f ? value : value / (eta_ * eta_);
}

bool RoughBoundary::sample(BsdfSample& out) const {
    Walk walk{-v_, 2.0f, true};
    for (int i = 0; i < kMostBounces; ++i) {
        if (!fly(walk)) {
            if ((walk.direction.z > 0.0f) != walk.here) return false;  // level with the surface
            out.direction = glm::normalize(t_ * walk.direction.x + b_ * walk.direction.y + n_ * walk.direction.z);
            out.weight = vec3(walk.here ? 1.0f : 1.0f / (eta_ * eta_));
            out.pdf = single_pdf(walk.direction);
            return true;
        }
        bounce(walk);
    }
    return false;
}

}  // namespace tyndall::reference
