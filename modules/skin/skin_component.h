#pragma once
/// The component that makes an entity's surfaces skin.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>

#include "ecs/description.h"
#include "profile_choice.h"
#include "scene/extraction.h"
#include "skin_plan.h"

namespace tyndall::skin {

/// How the oily layer mirrors.
enum class Specular { two_lobes, kelemen };

/// Whether light through thin parts goes by the body's thickness: where shadow maps do not say it and there is a map of
/// it; there in any case; or always.
enum class ThicknessUse { given, others, all };

/// Texture files; an empty name leaves what the material has.
struct SkinMaps {
    std::string colour;
    std::string normal;
    std::string roughness;
    std::string specular;
    std::string cavity;
    std::string oiliness;
    std::string thickness;
    bool operator==(const SkinMaps&) const = default;
};

struct SkinComponent {
    static constexpr std::string_view kName = "skin";
    ProfileChoice profile;
    Technique technique = Technique::separable;
    glm::vec3 tint{1.0f};
    float strength = 1.0f;
    float pre_scatter = 0.5f;
    float transmission = 1.0f;
    ThicknessUse thickness = ThicknessUse::given;
    float thickness_mm = 20.0f;
    Specular specular = Specular::two_lobes;
    glm::vec2 lobe_roughness{0.75f, 1.3f};
    float second_lobe = 0.15f;
    float detail_mm = 1.0f;
    SkinMaps maps;
    bool operator==(const SkinComponent&) const = default;
};
void describe(StructBuilder<SkinMaps>& d);
void describe(StructBuilder<SkinComponent>& d);

/// The profile as the artist wants it: `strength` scales distances, `tint` the share of each channel that spreads.
[[nodiscard]] physics::DiffusionProfile adjusted(physics::DiffusionProfile profile, const SkinComponent& component);

/// Makes the extractor, which keeps what it made for surfaces that did not change.
[[nodiscard]] Extractor make_skin_extractor();

}  // namespace tyndall::skin
