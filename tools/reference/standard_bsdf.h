#pragma once
/// The standard material as the truth has it: the GGX layer and the Lambertian base of physics/standard_surface.glsl,
/// with what bounces between microfacets and between layer and base in the reciprocal form of Kulla & Conty
/// ("Revisiting Physically Based Shading at Imageworks", 2017). The real-time renderer's form has the same albedo seen
/// from the eye, but depends on the eye's angle alone: it is not reciprocal, and differs by that.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>

#include "physics/physics.h"
#include "reference/geometry.h"

namespace tyndall::reference {

/// Directional albedo of the GGX lobe, finer than the renderer's table: over cosine and roughness, x for (F0, F90) =
/// (1, 0) and y for (0, 1), and their cosine-weighted means. Error below 5e-4.
class GgxAlbedo {
 public:
    /// Computes the table, over all cores.
    GgxAlbedo();
    [[nodiscard]] glm::vec2 directional(float cosine, float roughness) const;
    [[nodiscard]] glm::vec2 mean(float roughness) const;

 private:
    static constexpr int kSize = 64;
    std::vector<glm::vec2> directional_, mean_;
};

/// A material's values at a point.
struct MaterialPoint {
    glm::vec3 base_colour{0.8f};
    float opacity = 1.0f;  ///< coverage: 1 - what passes as if there were no surface
    float metallic = 0.0f;
    float roughness = 1.0f;
    glm::vec3 emissive{0.0f};  ///< cd/m2
    glm::vec3 f0{0.04f};       ///< of the dielectric layer
    float f90 = 1.0f;
    float thin_transmission = 0.0f;     ///< share of the base that lets light pass straight, tinted by the base colour
    float diffuse_transmission = 0.0f;  ///< share of the rest of the base that lets light through diffusely
    glm::vec3 diffuse_transmission_colour{1.0f};
    glm::vec3 normal{0.0f, 1.0f, 0.0f};  ///< with the normal map, on the outer side
};
[[nodiscard]] MaterialPoint material_at(const Material& material, const SurfacePoint& point);
/// What is painted over an interior.
struct PaintPoint {
    float cover = 0.0f;
    glm::vec3 colour{0.0f};
};
[[nodiscard]] PaintPoint paint_at(const Material& material, const SurfacePoint& point);
/// Coverage alone, for shadow rays.
[[nodiscard]] float opacity_at(const Material& material, const SurfacePoint& point);

struct BsdfSample {
    glm::vec3 direction{0.0f};
    glm::vec3 weight{0.0f};  ///< f cos / pdf
    float pdf = 0.0f;        ///< per steradian; infinite for a mirror
};

/// Reflection at a point, and what goes through it diffusely, of which the layers of both sides leave as much as of
/// the diffuse base. All directions point away from it, `v` to where the path comes from.
class StandardBsdf {
 public:
    /// `albedo` may be null for a material without a specular layer.
    StandardBsdf(const MaterialPoint& material, const GgxAlbedo* albedo, const glm::vec3& normal, const glm::vec3& v);
    /// f cos(l) per channel, 1/sr; `pdf` is that of `sample`.
    [[nodiscard]] glm::vec3 evaluate(const glm::vec3& l, float& pdf) const;
    /// False when the sampled direction is on the wrong side for its lobe.
    [[nodiscard]] bool sample(float lobe, glm::vec2 xi, BsdfSample& out) const;
    /// Share of light from `v` that meets the base and passes through it straight, for thin glass.
    [[nodiscard]] glm::vec3 base_transmission() const;
    [[nodiscard]] const glm::vec3& normal() const { return n_; }

 private:
    [[nodiscard]] glm::vec3 layer_albedo(float cosine) const;
    MaterialPoint m_;
    const GgxAlbedo* table_;
    glm::vec3 n_, v_;
    float nov_ = 1.0f;
    glm::vec3 f0_{0.0f}, f90_{0.0f};  ///< layer and metal together
    glm::vec3 base_{0.0f};            ///< albedo of the diffuse base
    glm::vec3 multiple_{0.0f};        ///< Kulla & Conty's Fresnel factor over pi (1 - mean albedo)
    glm::vec3 base_scale_{0.0f};      ///< base (1 - albedo of the layer at v) / (pi (1 - its mean))
    glm::vec3 through_{0.0f};         ///< albedo of the base for light to the other side
    glm::vec3 through_scale_{0.0f};   ///< as base_scale_
    float specular_share_ = 0.0f;     ///< probability of sampling the lobe
    float through_share_ = 0.0f;      ///< and of sampling the other side
};

}  // namespace tyndall::reference
