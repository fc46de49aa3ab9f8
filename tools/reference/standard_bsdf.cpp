#include "reference/standard_bsdf.h"

#include <cmath>

#include "core/parallel.h"
#include "physics/tables.h"
#include "reference/channels.h"
#include "reference/textures.h"

namespace tyndall::reference {
namespace {

using glm::vec2;
using glm::vec3;

constexpr int kAlbedoSteps = 48;
constexpr float kLeastCosine = 1e-3f;

/// Cosine-weighted mean over the hemisphere of Schlick's F.
vec3 mean_fresnel(const vec3& f0, const vec3& f90) {
    return f0 + (f90 - f0) / 21.0f;
}

/// Kulla & Conty, eq. 12: what share of the light that left the first bounce comes out in the end.
vec3 multiple_bounce_factor(const vec3& mean_f, float mean_albedo) {
    return mean_f * mean_f * mean_albedo / (vec3(1.0f) - mean_f * (1.0f - mean_albedo));
}

}  // namespace

GgxAlbedo::GgxAlbedo() : directional_(static_cast<size_t>(kSize) * kSize), mean_(kSize) {
    parallel_for(0, kSize, 1, [&](size_t first, size_t last) {
        for (size_t y = first; y < last; ++y)
            for (size_t x = 0; x < kSize; ++x) {
                const float root = static_cast<float>(x) / (kSize - 1);
                const float roughness = static_cast<float>(y) / (kSize - 1);
                directional_[y * kSize + x] = physics::ggx_directional_albedo(root * root, roughness, kAlbedoSteps);
            }
    });
    for (size_t y = 0; y < kSize; ++y) {
        // 2 integral of E c dc with c = s^2, by Simpson's rule in between the table's points
        glm::dvec2 sum(0.0);
        constexpr int kSteps = 512;
        for (int i = 0; i < kSteps; ++i) {
            const float s = (static_cast<float>(i) + 0.5f) / kSteps;
            const vec2 e = directional(s * s, static_cast<float>(y) / (kSize - 1));
            sum += glm::dvec2(e) * static_cast<double>(4.0f * s * s * s / kSteps);
        }
        mean_[y] = vec2(sum);
    }
}

vec2 GgxAlbedo::directional(float cosine, float roughness) const {
    const vec2 at = vec2(std::sqrt(glm::clamp(cosine, 0.0f, 1.0f)), glm::clamp(roughness, 0.0f, 1.0f)) *
                    static_cast<float>(kSize - 1);
    const glm::ivec2 low = glm::clamp(glm::ivec2(at), glm::ivec2(0), glm::ivec2(kSize - 2));
    const vec2 f = at - vec2(low);
    const vec2* row = &directional_[static_cast<size_t>(low.y * kSize + low.x)];
    return glm::mix(glm::mix(row[0], row[1], f.x), glm::mix(row[kSize], row[kSize + 1], f.x), f.y);
}

vec2 GgxAlbedo::mean(float roughness) const {
    const float at = glm::clamp(roughness, 0.0f, 1.0f) * static_cast<float>(kSize - 1);
    const auto low = static_cast<size_t>(glm::clamp(static_cast<int>(at), 0, kSize - 2));
    return glm::mix(mean_[low], mean_[low + 1], at - static_cast<float>(low));
}

float opacity_at(const Material& material, const SurfacePoint& point) {
    if (material.alpha_mode == AlphaMode::opaque) return 1.0f;
    const float alpha = material.base_colour.w * sample_slot(material.base_colour_texture, point).w;
    if (material.alpha_mode == AlphaMode::mask) return alpha < material.alpha_cutoff ? 0.0f : 1.0f;
    return glm::clamp(alpha, 0.0f, 1.0f);
}

MaterialPoint material_at(const Material& material, const SurfacePoint& point) {
    MaterialPoint m;
    const glm::vec4 base = sample_slot(material.base_colour_texture, point);
    m.base_colour = glm::clamp(vec3(material.base_colour) * vec3(base), vec3(0.0f), vec3(1.0f));
    m.opacity = opacity_at(material, point);
    const glm::vec4 metal = sample_slot(material.metallic_roughness_texture, point);
    m.metallic = glm::clamp(material.metallic * metal.z, 0.0f, 1.0f);
    m.roughness = glm::clamp(material.roughness * metal.y, 0.0f, 1.0f);
    m.emissive = material.emissive * vec3(sample_slot(material.emissive_texture, point));
    const float specular = material.specular * sample_slot(material.specular_texture, point).w;
    const vec3 tint = material.specular_colour * vec3(sample_slot(material.specular_colour_texture, point));
    const auto layer = physics::standard_material(m.base_colour, m.metallic, material.ior, specular, tint);
    m.f0 = layer.f0;
    m.f90 = layer.f90;
    const bool thin = material.transmission > 0.0f && material.thickness_m <= 0.0f;
    if (thin) m.thin_transmission = material.transmission * sample_slot(material.transmission_texture, point).x;
    if (material.diffuse_transmission > 0.0f) {
        const float share = sample_slot(material.diffuse_transmission_texture, point).w;
        const vec3 colour(sample_slot(material.diffuse_transmission_colour_texture, point));
        m.diffuse_transmission = glm::clamp(material.diffuse_transmission * share, 0.0f, 1.0f);
        m.diffuse_transmission_colour =
            glm::clamp(material.diffuse_transmission_colour * colour, vec3(0.0f), vec3(1.0f));
    }
    m.normal = point.normal;
    if (material.normal_texture.texture && point.tangent.w != 0.0f) {
        vec3 local = 2.0f * vec3(sample_slot(material.normal_texture, point)) - 1.0f;
        local.x *= material.normal_scale, local.y *= material.normal_scale;
        const vec3 t(point.tangent);
        const vec3 mapped = t * local.x + glm::cross(point.normal, t) * (point.tangent.w * local.y) +
                            point.normal * glm::max(local.z, 1e-3f);
        m.normal = glm::normalize(mapped);
    }
    return m;
}

PaintPoint paint_at(const Material& material, const SurfacePoint& point) {
    if (material.paint_cover <= 0.0f) return {};
    const glm::vec4 texel = sample_slot(material.paint_texture, point);
    return {glm::clamp(material.paint_cover * texel.w, 0.0f, 1.0f),
            glm::clamp(material.paint_colour * vec3(texel), vec3(0.0f), vec3(1.0f))};
}

StandardBsdf::StandardBsdf(const MaterialPoint& material, const GgxAlbedo* albedo, const vec3& normal, const vec3& v)
    : m_(material), table_(albedo), n_(normal), v_(v) {
    nov_ = glm::max(glm::dot(n_, v_), kLeastCosine);
    const float diffuse = (1.0f - m_.metallic) * (1.0f - m_.thin_transmission);
    base_ = m_.base_colour * diffuse * (1.0f - m_.diffuse_transmission);
    through_ = m_.diffuse_transmission_colour * diffuse * m_.diffuse_transmission;
    f0_ = glm::mix(m_.f0, m_.base_colour, m_.metallic);
    f90_ = vec3(glm::mix(m_.f90, 1.0f, m_.metallic));
    if (!table_ || largest(f0_) + largest(f90_) <= 0.0f) {
        table_ = nullptr;
        f0_ = f90_ = vec3(0.0f);
        base_scale_ = base_ * physics::kInversePi;
        through_scale_ = through_ * physics::kInversePi;
        const float all = largest(base_) + largest(through_);
        through_share_ = all > 0.0f ? largest(through_) / all : 0.0f;
        return;
    }
    const vec2 mean = table_->mean(m_.roughness);
    const float mean_albedo = mean.x + mean.y;
    const vec3 dielectric = multiple_bounce_factor(mean_fresnel(m_.f0, vec3(m_.f90)), mean_albedo);
    const vec3 metal = multiple_bounce_factor(mean_fresnel(m_.base_colour, vec3(1.0f)), mean_albedo);
    const float left = glm::max(1.0f - mean_albedo, 1e-6f);
    multiple_ = glm::mix(dielectric, metal, m_.metallic) * physics::kInversePi / left;
    const vec3 layer_mean = m_.f0 * mean.x + m_.f90 * mean.y + dielectric * (1.0f - mean_albedo);
    const vec3 leaves = vec3(1.0f) - layer_albedo(nov_);
    const vec3 scale = leaves * physics::kInversePi / glm::max(vec3(1.0f) - layer_mean, vec3(1e-4f));
    base_scale_ = base_ * scale;
    through_scale_ = through_ * scale;
    const vec2 e = table_->directional(nov_, m_.roughness);
    const float lobe = largest(f0_ * e.x + f90_ * e.y);
    const float through = largest(through_ * leaves);
    const float rest = largest(base_ * leaves) + largest(multiple_) * (1.0f - e.x - e.y) + through;
    specular_share_ = lobe + rest > 0.0f ? glm::clamp(lobe / (lobe + rest), 0.05f, 0.98f) : 0.0f;
    if (rest <= 0.0f) specular_share_ = 1.0f;
    through_share_ = rest > 0.0f ? (1.0f - specular_share_) * through / rest : 0.0f;
}

vec3 StandardBsdf::layer_albedo(float cosine) const {
    const vec2 e = table_->directional(cosine, m_.roughness);
    const vec2 mean = table_->mean(m_.roughness);
    const vec3 multiple = multiple_bounce_factor(mean_fresnel(m_.f0, vec3(m_.f90)), mean.x + mean.y);
    return glm::min(m_.f0 * e.x + m_.f90 * e.y + multiple * (1.0f - e.x - e.y), vec3(1.0f));
}

vec3 StandardBsdf::base_transmission() const {
    const vec3 entered = table_ ? vec3(1.0f) - layer_albedo(nov_) : vec3(1.0f);
    return m_.base_colour * entered * (m_.thin_transmission * (1.0f - m_.metallic));
}

vec3 StandardBsdf::evaluate(const vec3& l, float& pdf) const {
    const float nol = glm::dot(n_, l);
    pdf = 0.0f;
    if (nol <= 0.0f) {
        pdf = through_share_ * -nol * physics::kInversePi;
        if (!table_) return through_scale_ * -nol;
        return through_scale_ * (vec3(1.0f) - layer_albedo(-nol)) * -nol;
    }
    pdf = (1.0f - specular_share_ - through_share_) * nol * physics::kInversePi;
    if (!table_) return base_scale_ * nol;
    const float alpha = physics::ggx_alpha(m_.roughness);
    const vec3 h = glm::normalize(l + v_);
    const float w = physics::schlick_weight(glm::dot(v_, h));
    const float lobe = physics::ggx_distribution(n_, h, alpha) * physics::ggx_visibility(nol, nov_, alpha);
    pdf += specular_share_ * physics::ggx_reflection_pdf(n_, v_, h, alpha);
    const vec2 e_l = table_->directional(nol, m_.roughness);
    const vec2 e_v = table_->directional(nov_, m_.roughness);
    const vec3 multiple = multiple_ * ((1.0f - e_l.x - e_l.y) * (1.0f - e_v.x - e_v.y));
    const vec3 base = base_scale_ * (vec3(1.0f) - layer_albedo(nol));
    return ((f0_ * (1.0f - w) + f90_ * w) * lobe + multiple + base) * nol;
}

bool StandardBsdf::sample(float lobe, vec2 xi, BsdfSample& out) const {
    const bool through = lobe >= 1.0f - through_share_;
    if (lobe < specular_share_ && !through) {
        vec3 t, b;
        physics::orthonormal_basis(n_, t, b);
        const vec3 local(glm::dot(v_, t), glm::dot(v_, b), nov_);
        const vec3 h = physics::sample_ggx_visible_normal(xi, glm::normalize(local), physics::ggx_alpha(m_.roughness));
        const vec3 world = t * h.x + b * h.y + n_ * h.z;
        out.direction = glm::normalize(2.0f * glm::dot(v_, world) * world - v_);
    } else {
        out.direction = physics::to_frame(physics::sample_cosine_hemisphere(xi), through ? -n_ : n_);
    }
    if ((glm::dot(n_, out.direction) < 0.0f) != through) return false;
    const vec3 value = evaluate(out.direction, out.pdf);
    if (!(out.pdf > 0.0f)) return false;
    out.weight = value / out.pdf;
    return true;
}

}  // namespace tyndall::reference
