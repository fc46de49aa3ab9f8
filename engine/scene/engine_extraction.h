#pragma once
/// How the engine's own components become part of the RenderScene.

#include <string>
#include <string_view>

#include "core/error.h"
#include "scene/extraction.h"

namespace tyndall {

/// A transform without scale and shear: the direction of -Z is kept exactly, +Y as near as can be.
[[nodiscard]] glm::mat4 rigid_transform(const glm::mat4& transform);

/// Whether a name fits a pattern: '*' stands for any text, '?' for one character.
[[nodiscard]] bool matches_glob(std::string_view pattern, std::string_view name);

void add_light_extractors(Extractors& extractors);
void add_shape_extractors(Extractors& extractors);

/// Registers `extract(context, const T&, scene)` for the component T.
template <class T, class F>
void add_extractor(Extractors& extractors, F extract) {
    extractors.add(std::string(T::kName),
                   [extract](const ExtractContext& context, const void* component, RenderScene& scene) {
                       extract(context, *static_cast<const T*>(component), scene);
                   });
}

}  // namespace tyndall
