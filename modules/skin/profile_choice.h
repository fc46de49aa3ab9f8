#pragma once
/// Diffusion profiles as scenes choose them.

#include <glm/vec3.hpp>
#include <string>
#include <variant>
#include <vector>

#include "ecs/description.h"
#include "physics/diffusion_profile.h"

namespace tyndall::skin {

struct SixGaussiansProfile {
    bool operator==(const SixGaussiansProfile&) const = default;
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
void describe(StructBuilder<GaussianLobe>& d);
void describe(StructBuilder<GaussiansProfile>& d);

using ProfileChoice = std::variant<SixGaussiansProfile, GaussiansProfile>;
/// The alternatives' names in scene files, in their order.
[[nodiscard]] std::vector<std::string> profile_names();
/// Throws Error when there is nothing to make a profile of.
[[nodiscard]] physics::DiffusionProfile make_profile(const ProfileChoice& choice);

}  // namespace tyndall::skin
