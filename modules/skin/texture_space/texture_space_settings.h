#pragma once
/// What a scene may choose of the techniques in texture space.

#include "ecs/description.h"

namespace tyndall::skin {

/// The techniques six_gaussians and hable.
struct TextureSpaceSettings {
    int32_t size = 512;
    bool keep = true;
};

inline void describe(StructBuilder<TextureSpaceSettings>& d) {
    using S = TextureSpaceSettings;
    d.doc("Light maps of skin, laid out by the mesh's UVs.");
    d.field("size", &S::size,
            "Texels of a map along each side of the UVs' square. Skin that is seen small gets a half, a quarter or an "
            "eighth of it.")
        .range(64, 4096);
    d.field("keep", &S::keep, "Whether maps are kept while nothing that they show changes.");
}

}  // namespace tyndall::skin
