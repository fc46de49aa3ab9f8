#pragma once
/// The authoring component of this module.

#include <glm/vec3.hpp>

#include "ecs/description.h"

namespace tyndall::@NAME@ {

/// A veil that thickens with the distance from the eye.
struct @Name@Component {
    static constexpr std::string_view kName = "@NAME@";
    glm::vec3 radiance_cd_m2{1.0f, 0.8f, 0.5f};
    float density_per_m = 0.1f;
};

inline void describe(StructBuilder<@Name@Component>& d) {
    d.doc("A glowing veil that thickens with the distance from the eye.");
    d.field("radiance_cd_m2", &@Name@Component::radiance_cd_m2, "Radiance far away.").unit("cd/m2").range(0.0, 1e9).colour();
    d.field("density_per_m", &@Name@Component::density_per_m, "Extinction.").unit("1/m").range(0.0, 1e6);
}

}  // namespace tyndall::@NAME@
