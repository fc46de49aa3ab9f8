#pragma once
/// Which surfaces of a scene this module renders, and how.

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "body_size.h"
#include "paint/body_paint.h"
#include "scene/render_scene.h"

namespace tyndall::translucency {

enum class Technique { plain, points, htsm, radiance_maps, tsm, thickness, wrap, scatter_maps };
/// Names of the techniques as scenes have them, without "auto".
[[nodiscard]] const std::vector<std::string>& technique_names();

/// Whether light scatters inside.
[[nodiscard]] bool is_translucent(const Surface& surface);

/// How many times light is scattered in a body, roughly, and how much of it: what `auto` looks at.
struct Wandering {
    float lengths = 0.0f;  ///< the body's radius (body_radius) times the reduced scattering, largest channel
    float albedo = 0.0f;   ///< reduced, largest channel
};
/// Whether light that is scattered once is most of what a body gives back. By traces of a torus: with an albedo of 0.9
/// both are as far from the truth at 1.35 lengths, single scattering is three times nearer at 0.54 and diffusion at 1.4
/// with one of 0.94; with an albedo of 0.3 and 0.5 single scattering is nearer whatever the size.
[[nodiscard]] bool scatters_once(const Wandering& wandering);

/// Chooses a technique for each translucent surface of a frame. `auto` takes
/// - wrap where the body is seen smaller than a fiftieth of the picture's height;
/// - htsm where the interior's density is not the same everywhere, or where light is scattered about once;
/// - points otherwise (they choose how many by the size on screen).
/// What it takes is logged, once an entity.
class TechniquePlan {
 public:
    /// Indices of the scene's surfaces that are rendered with a technique. A name that does not exist is logged once,
    /// with the nearest, and means "auto".
    [[nodiscard]] std::vector<size_t> surfaces(const RenderScene& scene, Technique technique);
    /// What is painted over them.
    [[nodiscard]] PaintStore& paints() { return paints_; }

 private:
    /// What auto took for an entity, and what it goes by.
    struct Choice {
        Technique technique{};
        bool logged = false;
        BodyRadius size;
    };

    Technique technique_of(const Surface& surface, const Camera& camera);
    Technique automatic(const Surface& surface, const Camera& camera);
    static Wandering wandering(const Surface& surface, Choice& choice);
    static void log_choice(const Surface& surface, Choice& choice, Technique technique, std::string_view reason);

    PaintStore paints_;
    std::set<std::string> refused_;
    std::map<std::tuple<uint32_t, uint32_t, uint64_t>, Choice> choices_;  ///< by entity and mesh
};

}  // namespace tyndall::translucency
