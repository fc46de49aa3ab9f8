#pragma once
/// What a scene may choose of the techniques on the screen.

#include "ecs/description.h"
#include "texture_space/texture_space_settings.h"

namespace tyndall::skin {

struct SkinSettings {
    static constexpr std::string_view kName = "skin";
    bool enabled = true;
    int32_t taps = 11;
    int32_t disc_taps = 25;
    TextureSpaceSettings texture_space;
};

inline void describe(StructBuilder<SkinSettings>& d) {
    using S = SkinSettings;
    d.doc("Light under skin.");
    d.field("enabled", &S::enabled, "Whether light spreads at all; the oily layer stays.");
    d.field("taps", &S::taps,
            "Pixels that each of the two passes of separable and two_gaussians looks at where skin fills the picture "
            "as a portrait does; closer up there are more. Made odd.")
        .range(3, 63);
    d.field("disc_taps", &S::disc_taps, "Pixels that the technique disc looks at.").range(4, 64);
    d.field("texture_space", &S::texture_space, "Techniques six_gaussians and hable.");
}

}  // namespace tyndall::skin
