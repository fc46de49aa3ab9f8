#pragma once
/// How phase functions, densities and interiors are authored: described structs that media and interiors share, and
/// what they become.

#include <string>
#include <variant>
#include <vector>

#include "ecs/description.h"
#include "geometry/bounds.h"
#include "scene/asset_store.h"
#include "scene/scattering.h"
#include "scene/volume_sequence.h"

namespace tyndall {

// Phase functions
// ---------------------------------------------------------------------------------------------------------------

struct IsotropicPhase {};
struct RayleighPhase {};
struct HenyeyGreensteinPhase {
    float g = 0.6f;
};
struct SchlickPhase {
    float g = 0.6f;
};
struct CornetteShanksPhase {
    float g = 0.6f;
};
struct TwoLobePhase {
    float g0 = 0.8f;
    float g1 = -0.3f;
    float weight = 0.3f;
};
struct WaterDropletPhase {
    float diameter_um = 20.0f;
};
struct DrainePhase {
    float g = 0.6f;
    float a = 1.0f;
};
struct TabulatedPhase {
    std::string file;
};

void describe(StructBuilder<IsotropicPhase>& d);
void describe(StructBuilder<RayleighPhase>& d);
void describe(StructBuilder<HenyeyGreensteinPhase>& d);
void describe(StructBuilder<SchlickPhase>& d);
void describe(StructBuilder<CornetteShanksPhase>& d);
void describe(StructBuilder<TwoLobePhase>& d);
void describe(StructBuilder<WaterDropletPhase>& d);
void describe(StructBuilder<DrainePhase>& d);
void describe(StructBuilder<TabulatedPhase>& d);

using PhaseChoice = std::variant<IsotropicPhase, HenyeyGreensteinPhase, SchlickPhase, RayleighPhase,
                                 CornetteShanksPhase, TwoLobePhase, WaterDropletPhase, DrainePhase, TabulatedPhase>;
/// The alternatives' names in scene files, in their order.
[[nodiscard]] std::vector<std::string> phase_names();
/// Throws Error when a table cannot be loaded.
[[nodiscard]] PhaseFunction make_phase(const PhaseChoice& choice, AssetStore& assets);
/// Mean cosine of the scattering angle per channel.
[[nodiscard]] glm::vec3 mean_cosine(const PhaseFunction& phase);

// Densities
// ---------------------------------------------------------------------------------------------------------------

/// How a volume's box lies in the box that it fills.
enum class VolumeFit { stretch, contain };
/// Files of a sequence by number; in use where a file's name has a #.
struct SequenceChoice {
    int32_t first = 1, last = 1, step = 1;
    float frames_per_s = 24.0f;
    float start_s = 0.0f;
    Playback playback = Playback::loop;
};
struct MotionBlur {
    std::string grid;
    float shutter_s = 0.0f;
};
struct VolumeDensity {
    std::string file;
    std::string grid;
    float scale = 1.0f;
    VolumeFit fit = VolumeFit::stretch;
    glm::vec3 low_m{0.0f}, high_m{0.0f};
    SequenceChoice sequence;
    MotionBlur motion_blur;
};
struct LinearGradient {
    glm::vec3 from{0.0f, -0.5f, 0.0f}, to{0.0f, 0.5f, 0.0f};
    float start = 1.0f, end = 0.0f;
};
struct RadialGradient {
    glm::vec3 centre{0.0f};
    float inner_radius = 0.0f, outer_radius = 0.5f;
    float start = 1.0f, end = 0.0f;
};

void describe(StructBuilder<ConstantDensity>& d);
void describe(StructBuilder<HeightDensity>& d);
void describe(StructBuilder<BlobDensity::Blob>& d);
void describe(StructBuilder<BlobDensity>& d);
void describe(StructBuilder<NoiseDensity>& d);
void describe(StructBuilder<SequenceChoice>& d);
void describe(StructBuilder<MotionBlur>& d);
void describe(StructBuilder<VolumeDensity>& d);
void describe(StructBuilder<LinearGradient>& d);
void describe(StructBuilder<RadialGradient>& d);

using DensityChoice = std::variant<ConstantDensity, HeightDensity, BlobDensity, NoiseDensity, VolumeDensity,
                                   LinearGradient, RadialGradient>;
/// The alternatives' names in scene files, in their order.
[[nodiscard]] std::vector<std::string> density_names();
/// Where and when a volume is shown.
struct VolumePlace {
    Bounds box;  ///< what it fills, in local space
    glm::mat4 local_to_world;
    double time_s = 0.0;
};
/// Throws Error when a volume cannot be loaded.
[[nodiscard]] DensityField make_density(const DensityChoice& choice, AssetStore& assets, const VolumePlace& place);
/// A grid of the volume's file, placed as its density is: grids of a file, and frames of a sequence, keep their places
/// relative to each other. Its volume is null while a sequence's first frame is still on its way.
[[nodiscard]] GridDensity placed_volume(const VolumeDensity& from, const std::string& grid, AssetStore& assets,
                                        const VolumePlace& place);

// Interiors
// ---------------------------------------------------------------------------------------------------------------

/// Coefficients in 1/m or 1/mm; `reduced`: the scattering is (1 - mean cosine) times the true one, as tables have it.
template <int PerMetre>
struct Coefficients {
    glm::vec3 scattering{1000.0f / PerMetre};
    glm::vec3 absorption{10.0f / PerMetre};
    bool reduced = false;
};
using CoefficientsPerM = Coefficients<1>;
using CoefficientsPerMm = Coefficients<1000>;
struct AlbedoOptics {
    glm::vec3 albedo{0.99f};
    glm::vec3 mean_free_path_mm{1.0f};
};
struct TransmissionColourOptics {
    glm::vec3 colour{1.0f};
    float at_m = 0.01f;
};
struct TransportColourOptics {
    glm::vec3 colour{1.0f, 0.8f, 0.6f};
    float at_m = 0.01f;
    glm::vec3 mean_free_path_mm{1.0f};
};

void describe(StructBuilder<CoefficientsPerM>& d);
void describe(StructBuilder<CoefficientsPerMm>& d);
void describe(StructBuilder<AlbedoOptics>& d);
void describe(StructBuilder<TransmissionColourOptics>& d);
void describe(StructBuilder<TransportColourOptics>& d);

/// A diffuse layer painted over an interior.
struct InteriorPaint {
    float cover = 0.0f;
    glm::vec3 colour{0.8f};
    std::string texture;
    bool operator==(const InteriorPaint&) const = default;
};
void describe(StructBuilder<InteriorPaint>& d);

/// What is inside the entity's meshes.
struct InteriorComponent {
    static constexpr std::string_view kName = "interior";
    std::variant<CoefficientsPerMm, CoefficientsPerM, AlbedoOptics, TransmissionColourOptics, TransportColourOptics>
        optics;
    PhaseChoice phase;
    DensityChoice density;
    glm::vec3 emission_cd_m2_per_m{0.0f};
    float ior = 1.3f;
    float roughness = 0.0f;
    InteriorPaint paint;
    int32_t priority = 0;
    std::string technique = "auto";
};
void describe(StructBuilder<InteriorComponent>& d);

/// The interior of a mesh whose local bounds are the place's box. Throws Error when a file of it cannot be loaded.
[[nodiscard]] ScatteringInterior make_interior(const InteriorComponent& from, AssetStore& assets,
                                               const VolumePlace& place);
/// The boundary of an interior that scatters as a material: a dielectric layer over a base that returns as much of the
/// light that enters as a half-space of what is inside does (physics/half_space.h).
[[nodiscard]] Material boundary_material(const ScatteringInterior& interior, const std::string& name);
/// What a glTF material with full transmission and a thickness says of its inside; none for others.
[[nodiscard]] std::optional<ScatteringInterior> interior_of_material(const Material& material);

}  // namespace tyndall
