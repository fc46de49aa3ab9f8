#pragma once
/// Which surfaces of a scene this module renders, and how.

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "scene/render_scene.h"

namespace tyndall::translucency {

enum class Technique { plain, points };
/// Names of the techniques as scenes have them, without "auto".
[[nodiscard]] const std::vector<std::string>& technique_names();

/// Whether light scatters inside.
[[nodiscard]] bool is_translucent(const Surface& surface);

/// Chooses a technique for each translucent surface of a frame.
class TechniquePlan {
 public:
    /// Indices of the scene's surfaces that are rendered with a technique. A name that does not exist is logged once,
    /// with the nearest, and means "auto".
    [[nodiscard]] std::vector<size_t> surfaces(const RenderScene& scene, Technique technique);

 private:
    Technique technique_of(const Surface& surface);
    std::set<std::string> refused_;
};

}  // namespace tyndall::translucency
