#pragma once
/// Light from far away all around: the scene's probe without a box or, where there is none, its sky.

#include <span>
#include <vector>

#include "physics/probe.h"
#include "scene/render_scene.h"

namespace tyndall {

/// The one of a scene. Black where there is none.
struct Environment {
    std::shared_ptr<const TextureAsset> image;  ///< null = the same from everywhere
    glm::vec3 radiance{0.0f};                   ///< cd/m2; multiplies the image when there is one
    glm::mat3 world_from_image{1.0f};
    LightsRequest lights;
    Entity entity;  ///< the probe's; null for the sky
};
[[nodiscard]] Environment environment_of(const RenderScene& scene);

/// An environment's image averaged down to at most 256 by 128 pixels of three floats: enough for diffuse light.
[[nodiscard]] Image small_environment(const TextureAsset& image);
/// Its pixels, top row first.
[[nodiscard]] std::span<const glm::vec3> pixels_of(const Image& image);

/// Turns the environment into directional lights where the scene asks for them. Remembers the last image's.
class LightsOfEnvironment {
 public:
    /// Appends them to the scene's lights.
    void add_to(RenderScene& scene);

 private:
    void sample(const Environment& environment);

    uint64_t image_ = 0;
    int count_ = 0;
    std::vector<physics::DistantLight> lights_;
};

}  // namespace tyndall
