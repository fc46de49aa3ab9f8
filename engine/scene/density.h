#pragma once
/// Evaluating and bounding density fields on the CPU.

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "geometry/bounds.h"
#include "scene/scattering.h"

namespace tyndall {

/// A grid ready for many lookups.
class GridEvaluator {
 public:
    explicit GridEvaluator(const GridDensity& grid);

    /// At a place in local space; 0 outside of the grid. Never negative, finite.
    [[nodiscard]] float at(const glm::vec3& local) const;
    /// No value inside a local box is above this.
    [[nodiscard]] float upper_bound(const Bounds& local) const;

 private:
    struct MaximaOfBlocks;
    GridDensity grid_;
    glm::mat4 map_{1.0f};  ///< from local to voxels, whose centres are at whole numbers
    std::shared_ptr<const MaximaOfBlocks> maxima_;
};

/// A density field at one moment, ready for many lookups. Holds what the field shares.
class DensityEvaluator {
 public:
    /// `local_to_world` as of the medium's box or the interior's mesh; `time_s` is the scene's.
    DensityEvaluator(DensityField field, const glm::mat4& local_to_world, double time_s);

    /// 1 everywhere: no lookups are needed.
    [[nodiscard]] bool constant() const { return std::holds_alternative<ConstantDensity>(field_); }
    /// At a place in local space; never negative, finite.
    [[nodiscard]] float at(const glm::vec3& local) const;
    /// No value inside a local box is above this.
    [[nodiscard]] float upper_bound(const Bounds& local) const;

 private:
    /// A blob as the loop over them wants it.
    struct PreparedBlob {
        glm::vec3 centre;
        float exponent;  ///< times the squared distance
        float weight;
    };

    [[nodiscard]] float blobs_at(const glm::vec3& local) const;
    [[nodiscard]] float noise_at(const glm::vec3& local) const;
    [[nodiscard]] float gradient_at(const glm::vec3& local) const;
    [[nodiscard]] float blobs_bound(const Bounds& local) const;
    [[nodiscard]] float noise_bound(const Bounds& local) const;
    [[nodiscard]] float gradient_bound(const Bounds& local) const;
    void prepare_height(const HeightDensity& height, const glm::mat4& local_to_world);
    void prepare_blobs(const BlobDensity& density);
    void prepare_noise(const NoiseDensity& noise, const glm::mat4& local_to_world, double time_s);
    void prepare_product(const ProductDensity& product, const glm::mat4& local_to_world, double time_s);

    DensityField field_;
    // Height: the exponent is linear in the local place.
    glm::dvec3 exponent_slope_{0.0};
    double exponent_ = 0.0;
    std::vector<PreparedBlob> blobs_;
    glm::mat4 map_{1.0f};  ///< from local to features of the noise
    float churn_ = 0.0f;   ///< features, by now
    std::optional<GridEvaluator> grid_;
    std::vector<DensityEvaluator> factors_;  ///< of a product
};

}  // namespace tyndall
