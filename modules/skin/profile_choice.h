#pragma once
/// Diffusion profiles as scenes choose them.

#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "ecs/description.h"
#include "physics/diffusion_profile.h"
#include "physics/profile_corrections.h"
#include "physics/slab_transmittance.h"

namespace tyndall::skin {

/// Index of refraction of skin: a mirror of 0.028 at normal incidence.
inline constexpr float kSkinIor = 1.4f;

struct SixGaussiansProfile {
    bool operator==(const SixGaussiansProfile&) const = default;
};
struct Skin1Profile {
    bool operator==(const Skin1Profile&) const = default;
};
struct Skin2Profile {
    bool operator==(const Skin2Profile&) const = default;
};
struct ThreeLayersProfile {
    bool operator==(const ThreeLayersProfile&) const = default;
};
struct BurleyProfile {
    glm::vec3 albedo{0.46f, 0.23f, 0.13f};
    glm::vec3 mean_free_path_mm{1.3f, 0.95f, 0.67f};
    bool operator==(const BurleyProfile&) const = default;
};
struct ProfileLayer {
    float thickness_mm = 0.0f;
    glm::vec3 absorption_per_mm{0.032f, 0.17f, 0.48f};
    glm::vec3 scattering_per_mm{0.74f, 0.88f, 1.01f};
    float ior = 1.4f;
    bool operator==(const ProfileLayer&) const = default;
};
struct LayersProfile {
    std::vector<ProfileLayer> layers;
    bool operator==(const LayersProfile&) const = default;
};
struct GaussianLobe {
    float variance_mm2 = 1.0f;
    glm::vec3 weight{1.0f};
    bool operator==(const GaussianLobe&) const = default;
};
struct GaussiansProfile {
    std::vector<GaussianLobe> lobes;
    bool operator==(const GaussiansProfile&) const = default;
};

void describe(StructBuilder<SixGaussiansProfile>& d);
void describe(StructBuilder<Skin1Profile>& d);
void describe(StructBuilder<Skin2Profile>& d);
void describe(StructBuilder<ThreeLayersProfile>& d);
void describe(StructBuilder<BurleyProfile>& d);
void describe(StructBuilder<ProfileLayer>& d);
void describe(StructBuilder<LayersProfile>& d);
void describe(StructBuilder<GaussianLobe>& d);
void describe(StructBuilder<GaussiansProfile>& d);

using ProfileChoice = std::variant<SixGaussiansProfile, Skin1Profile, Skin2Profile, ThreeLayersProfile, BurleyProfile,
                                   LayersProfile, GaussiansProfile>;
/// The alternatives' names in scene files, in their order.
[[nodiscard]] std::vector<std::string> profile_names();

/// A profile and what else is known of it.
struct MadeProfile {
    physics::DiffusionProfile profile;
    /// Of the light that has entered, what leaves: 1 where the choice says nothing of it.
    glm::vec3 albedo{1.0f};
    glm::vec3 fit_error{0.0f};   ///< ProfileFit::error; 0 where the profile is Gaussians by itself
    glm::vec3 edge_error{0.0f};  ///< ProfileFit::edge_error
    /// What comes through thin parts, where the profile follows from coefficients; otherwise DiffusionProfile::through
    /// is all that is known.
    std::optional<physics::SlabTransmittance> transmittance;
    physics::ProfileCorrections corrections;  ///< none where the choice says nothing of the albedo
};

/// Throws Error when there is nothing to make a profile of, or no such thing can be. The last ones made are kept, so
/// that the same choice costs nothing again; a fit takes 30 ms, of layers 150 ms. Any thread.
[[nodiscard]] std::shared_ptr<const MadeProfile> made_profile(const ProfileChoice& choice);
/// Its profile.
[[nodiscard]] physics::DiffusionProfile make_profile(const ProfileChoice& choice);

}  // namespace tyndall::skin
