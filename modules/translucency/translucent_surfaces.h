#pragma once
/// Which surfaces of a scene this module renders, and how.

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/render_scene.h"

namespace tyndall::translucency {

enum class Technique { plain, points, htsm, radiance_maps, tsm, thickness, wrap, scatter_maps };
/// Names of the techniques as scenes have them, without "auto".
[[nodiscard]] const std::vector<std::string>& technique_names();

/// Whether light scatters inside.
[[nodiscard]] bool is_translucent(const Surface& surface);

/// Chooses a technique for each translucent surface of a frame. `auto` takes htsm where the interior's density is not
/// the same everywhere, and points otherwise; what it takes is logged, once an entity.
class TechniquePlan {
 public:
    /// Indices of the scene's surfaces that are rendered with a technique. A name that does not exist is logged once,
    /// with the nearest, and means "auto".
    [[nodiscard]] std::vector<size_t> surfaces(const RenderScene& scene, Technique technique);

 private:
    Technique technique_of(const Surface& surface);
    void log_choice(const Surface& surface, Technique technique, std::string_view reason);

    std::set<std::string> refused_;
    std::map<std::pair<uint32_t, uint32_t>, Technique> logged_;  ///< what auto chose, by entity
};

}  // namespace tyndall::translucency
