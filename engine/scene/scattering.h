#pragma once
/// What scatters, for every solver: phase functions, and where how much of a medium is.

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "image/volume.h"

namespace tyndall {

/// Values and parameters are those of PHASE_... in physics/phase.glsl; `tabulated` has its table instead.
enum class PhaseKind : int32_t {
    isotropic,
    rayleigh,
    henyey_greenstein,
    schlick,
    cornette_shanks,
    two_lobe,
    draine,
    mie_droplets,
    tabulated
};

/// A measured or computed phase function per channel: values in 1/sr at evenly spaced scattering angles from 0 to pi
/// (the first is forward), linear between them, each channel integrating to 1 over the sphere.
struct PhaseTable {
    uint64_t id = 0;
    std::string name;
    std::vector<glm::vec3> values;  ///< at least 2
};

struct PhaseFunction {
    PhaseKind kind = PhaseKind::isotropic;
    glm::vec4 parameters{0.0f};
    std::shared_ptr<const PhaseTable> table;  ///< tabulated only
};

/// A density on a grid, shared. `id` as for MeshAsset.
struct VolumeAsset {
    uint64_t id = 0;
    std::string name;
    Volume volume;
};

// Densities multiply the coefficients of a medium or an interior. `local` is the unit box [-1/2, 1/2]^3 of a medium,
// and the object space of an interior's mesh.

/// 1 everywhere.
struct ConstantDensity {};

/// exp(-(y - base_m) / scale_height_m) of the height y in the world; 1 at the base, more below it.
struct HeightDensity {
    float base_m = 0.0f;
    float scale_height_m = 1.0f;
};

/// Sum over blobs of weight exp(-|p - centre|^2 / (2 radius^2)), p local.
struct BlobDensity {
    struct Blob {
        glm::vec3 centre{0.0f};
        float radius = 0.1f;  ///< standard deviation
        float weight = 1.0f;
    };
    std::vector<Blob> blobs;
};

/// Values are those of NOISE_... in physics/noise.glsl.
enum class NoiseKind : int32_t { perlin, worley };

/// Fractal noise of the place in the world, between 0 and 1 (physics/noise.glsl).
struct NoiseDensity {
    float feature_m = 1.0f;    ///< size of the largest features
    int octaves = 4;           ///< each half as large and half as strong
    float coverage = 0.5f;     ///< share of space that is not empty, roughly
    glm::vec3 wind_m_s{0.0f};  ///< moves it with the scene's time
    NoiseKind kind = NoiseKind::perlin;
    float swirl = 0.0f;        ///< curl noise displaces the places looked up by about so many features
    float churn_per_s = 0.0f;  ///< features by which the swirls change in a second
};

/// A grid, trilinear between voxel centres, 0 outside of it.
struct GridDensity {
    std::shared_ptr<const VolumeAsset> volume;
    glm::mat4 to_volume{1.0f};  ///< from local to [0, 1]^3 over the grid's box
    float scale = 1.0f;         ///< multiplies its values
};

/// A ramp in local space: `start` up to one side, `end` from the other on, linear between (physics/ramp.glsl).
struct GradientDensity {
    bool radial = false;
    glm::vec3 from{0.0f, -0.5f, 0.0f};  ///< linear: where it starts; radial: the centre
    glm::vec3 to{0.0f, 0.5f, 0.0f};     ///< linear: where it ends
    float inner = 0.0f, outer = 0.5f;   ///< radial: the radii between which it changes
    float start = 1.0f, end = 0.0f;
};

/// What limits and shapes another density.
struct ProductDensity;

using DensityField = std::variant<ConstantDensity, HeightDensity, BlobDensity, NoiseDensity, GridDensity,
                                  GradientDensity, ProductDensity>;

/// One of the other densities, times a mask (where a mesh or particles are), times a layer's fall with height.
struct ProductDensity {
    std::shared_ptr<const DensityField> base;  ///< no product; not null
    std::optional<GridDensity> mask;
    std::optional<HeightDensity> layer;
};

/// A temperature on a grid, in kelvin: what is outside of it is at `base_k`.
struct TemperatureField {
    GridDensity grid;     ///< its scale: kelvin per unit of the grid
    float base_k = 0.0f;  ///< added
};

}  // namespace tyndall
