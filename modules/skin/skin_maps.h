#pragma once
/// Maps of skin as the engine's materials take them.

#include <memory>

#include "scene/asset_store.h"
#include "skin_component.h"

namespace tyndall::skin {

/// Puts the maps into the material: roughness (lower by up to half where oily) and specular times cavity are made into
/// the maps of glTF's model. Throws Error when a file cannot be loaded.
void set_maps(const SkinMaps& maps, AssetStore& assets, Material& material);

}  // namespace tyndall::skin
