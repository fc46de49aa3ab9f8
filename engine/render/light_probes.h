#pragma once
/// Light from all around: the scene's probes and its sky, as the seams' providers "light_probes" and "sky".
///
/// Irradiance comes from nine spherical harmonics, or from the scene's lights where it is turned into lights; the
/// specular lobe from maps filtered for rising roughness, on octahedra: one layer an image, one mip a roughness.

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "gpu/gpu.h"
#include "gpu/shader_library.h"
#include "physics/physics.h"
#include "render/frame_graph.h"
#include "scene/render_scene.h"

namespace tyndall {

class Seams;

/// Filters each image once, on the GPU. The nearest boxes win; what they leave falls to whole-scene probes, then to the
/// sky.
class LightProbes {
 public:
    /// Probes beyond this many are ignored, the largest first.
    static constexpr size_t kMaxProbes = 32;

    explicit LightProbes(gpu::ShaderLibrary& shaders) : shaders_(shaders) {}
    /// Adds both providers; the probes must outlive the seams.
    void provide(Seams& seams);
    /// Once a frame, before passes run.
    void update(const RenderScene& scene);

 private:
    /// An image's light, filtered.
    struct Filtered {
        int layer = 0;
        physics::Sh9 harmonics;
        bool used = false;  ///< in this frame
    };
    /// The struct ProbeRecord of render/shaders/light_probes.glsl.
    struct Record {
        glm::mat4 local_from_world;
        glm::vec4 extent_blend;
        glm::vec4 scale_layer;
        physics::Sh9 harmonics;
    };

    void add(const LightProbe& probe);
    void add(const Sky& sky);
    const Filtered& filtered(const TextureAsset& image);
    int free_layer();
    void prefilter(const Image& small, int layer);
    void bind(const gpu::Program& program) const;

    gpu::ShaderLibrary& shaders_;
    std::unordered_map<uint64_t, Filtered> images_;  // by asset id
    std::vector<Record> records_;
    gpu::Texture maps_;
    gpu::Buffer block_;
};

}  // namespace tyndall
