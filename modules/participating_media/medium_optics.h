#pragma once
/// What a medium does to light: the choices that the component `medium` has.

#include <glm/vec3.hpp>
#include <string>
#include <variant>
#include <vector>

#include "ecs/description.h"

namespace tyndall::participating_media {

/// The component's own scattering_per_m and absorption_per_m.
struct CoefficientFields {};
struct AlbedoMetres {
    glm::vec3 albedo{0.9f};
    glm::vec3 mean_free_path_m{10.0f};
};
struct ColourAtDistance {
    glm::vec3 colour{0.5f};
    float at_m = 10.0f;
    glm::vec3 albedo{0.5f};
};
void describe(StructBuilder<CoefficientFields>& d);
void describe(StructBuilder<AlbedoMetres>& d);
void describe(StructBuilder<ColourAtDistance>& d);

using OpticsChoice = std::variant<CoefficientFields, AlbedoMetres, ColourAtDistance>;
/// The alternatives' names in scene files, in their order.
[[nodiscard]] std::vector<std::string> optics_names();

/// Scattering and absorption coefficients in 1/m.
struct Optics {
    glm::vec3 sigma_s{0.0f};
    glm::vec3 sigma_a{0.0f};
};
/// `fields` are what CoefficientFields stand for.
[[nodiscard]] Optics make_optics(const OpticsChoice& choice, const Optics& fields);

/// The glow of what is hot: by Kirchhoff's law the absorption times the radiance of a black body.
struct BlackBody {
    float temperature_k = 0.0f;
    std::string file;
    std::string grid;
    float kelvin_per_unit = 1.0f;
};
void describe(StructBuilder<BlackBody>& d);

}  // namespace tyndall::participating_media
