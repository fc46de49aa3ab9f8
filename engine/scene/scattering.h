#pragma once
/// What scatters, for every solver: phase functions, and where how much of a medium is.

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
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

/// Fractal gradient noise of the place in the world, between 0 and 1 (physics/noise.glsl).
struct NoiseDensity {
    float feature_m = 1.0f;    ///< size of the largest features
    int octaves = 4;           ///< each half as large and half as strong
    float coverage = 0.5f;     ///< share of space that is not empty, roughly
    glm::vec3 wind_m_s{0.0f};  ///< moves it with the scene's time
};

/// A grid, trilinear between voxel centres, 0 outside of it.
struct GridDensity {
    std::shared_ptr<const VolumeAsset> volume;
    glm::mat4 to_volume{1.0f};  ///< from local to [0, 1]^3 over the grid's box
    float scale = 1.0f;         ///< multiplies its values
};

using DensityField = std::variant<ConstantDensity, HeightDensity, BlobDensity, NoiseDensity, GridDensity>;

}  // namespace tyndall
