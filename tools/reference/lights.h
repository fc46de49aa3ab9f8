#pragma once
/// Everything that gives off light, and how likely the tracer looks there.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "reference/geometry.h"
#include "scene/render_scene.h"

namespace tyndall::reference {

/// Light from one direction.
struct LightSample {
    glm::vec3 direction{0.0f};  ///< unit, toward the light
    float distance_m = 0.0f;    ///< may be infinite
    glm::vec3 light{0.0f};      ///< radiance over its density; of a light without size: irradiance facing it
    float pdf = 0.0f;           ///< per steradian, given the light; 0 for a light without size
    bool placed = true;         ///< of a light entity: surfaces that cast no shadow let it pass
};

/// An image of the surroundings and its importance: luminance times solid angle (Pharr et al., PBRT, 12.5).
class Environment {
 public:
    Environment() = default;
    /// `image` may be null: the plain radiance is then all there is.
    Environment(std::shared_ptr<const TextureAsset> image, const glm::vec3& radiance, const glm::mat3& rotation);
    [[nodiscard]] bool dark() const { return mean_ <= 0.0f; }
    [[nodiscard]] float mean_luminance() const { return mean_; }
    [[nodiscard]] glm::vec3 radiance(const glm::vec3& direction) const;
    [[nodiscard]] glm::vec3 sample(glm::vec2 xi, float& pdf) const;
    [[nodiscard]] float pdf(const glm::vec3& direction) const;

 private:
    [[nodiscard]] float texel_pdf(int x, int y) const;
    std::shared_ptr<const TextureAsset> image_;
    glm::vec3 radiance_{0.0f};
    glm::mat3 rotation_{1.0f};
    float mean_ = 0.0f;
    int width_ = 0, height_ = 0;
    std::vector<float> rows_, columns_;  ///< running sums: of the rows, and in each row
};

/// See the file's head. Lights are numbered; the emissive triangles together are one light, the environment another.
class Lights {
 public:
    Lights(const RenderScene& scene, const Geometry& geometry);

    [[nodiscard]] size_t count() const { return entries_.size(); }
    /// Has a place: near it, light depends strongly on where along a ray it is met.
    [[nodiscard]] bool positional(size_t light) const;
    [[nodiscard]] bool sized(size_t light) const;  ///< can be met by a ray
    [[nodiscard]] bool any_sized() const { return any_sized_; }
    [[nodiscard]] glm::vec3 position(size_t light) const;

    /// Estimates of what each light gives a point, for choosing one. 0 only where it gives nothing.
    [[nodiscard]] float weight_at(size_t light, const glm::vec3& point) const;
    /// The same over the part [t0, t1] of a ray, which is narrowed to what the light reaches.
    [[nodiscard]] float weight_along(size_t light, const Ray& ray, float& t0, float& t1) const;
    /// Probability of choosing `light` at a point by weight_at.
    [[nodiscard]] float probability_at(size_t light, const glm::vec3& point) const;
    /// Chooses by weight_at; false when it is dark there.
    bool choose_at(float xi, const glm::vec3& point, size_t& light, float& probability) const;

    /// False when no light comes from there.
    bool sample(size_t light, const glm::vec3& point, glm::vec2 xi, LightSample& out) const;

    /// What a ray meets of the lights that are not triangles, between its start and ray.far_m: calls
    /// `visit(light, radiance, pdf, metres)`. The background counts when `missed`.
    template <class F>
    void met(const Ray& ray, bool missed, F visit) const {
        for (size_t i = 0; i < entries_.size(); ++i) {
            glm::vec3 radiance;
            float pdf = 0.0f, metres = 0.0f;
            if (meets(i, ray, missed, radiance, pdf, metres)) visit(i, radiance, pdf, metres);
        }
    }
    /// What the camera sees where there is nothing.
    [[nodiscard]] glm::vec3 background(const glm::vec3& direction) const { return sky_.radiance(direction); }

    /// Number of the light that the emissive triangles are, or count() without any.
    [[nodiscard]] size_t triangles_light() const { return triangles_light_; }
    /// Density per steradian of sampling this hit from `from`, given the triangles were chosen.
    [[nodiscard]] float triangle_pdf(const Hit& hit, const SurfacePoint& point, const glm::vec3& from) const;
    /// What a surface gives off at a point toward `direction`.
    [[nodiscard]] glm::vec3 emitted(uint32_t surface, const SurfacePoint& point, const glm::vec3& direction) const;

 private:
    enum class Kind { placed, directional, environment, triangles };
    struct Entry {
        Kind kind = Kind::placed;
        Light light;            ///< placed, directional
        float strength = 0.0f;  ///< luminance of the intensity or illuminance
        float cos_inner = 1.0f, cos_outer = -1.0f, cos_radius = 1.0f;
    };
    struct Triangle {
        uint32_t surface = 0, triangle = 0;
        float area = 0.0f, power = 0.0f;
    };
    void add_triangles(const RenderScene& scene);
    [[nodiscard]] glm::vec3 intensity_toward(const Entry& entry, const glm::vec3& point, const glm::vec3& to_light,
                                             float metres) const;
    bool sample_placed(const Entry& entry, const glm::vec3& point, glm::vec2 xi, LightSample& out) const;
    bool sample_directional(const Entry& entry, const glm::vec3& point, glm::vec2 xi, LightSample& out) const;
    bool sample_triangles(const glm::vec3& point, glm::vec2 xi, LightSample& out) const;
    bool meets(size_t light, const Ray& ray, bool missed, glm::vec3& radiance, float& pdf, float& metres) const;

    const Geometry& geometry_;
    std::vector<Surface> surfaces_;
    std::vector<Entry> entries_;
    Environment sky_, environment_;
    std::vector<Triangle> triangles_;
    std::vector<float> triangle_sums_;
    std::vector<std::vector<float>> triangle_power_;  ///< by surface and triangle; empty = not emissive
    Bounds triangle_bounds_;
    size_t triangles_light_ = 0;
    bool any_sized_ = false;
};

}  // namespace tyndall::reference
