#pragma once
/// Spreads a light map over its surface by a diffusion profile, on the GPU.

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "gpu/shader_library.h"
#include "texture_space/gpu_atlas.h"
#include "texture_space/lobe_plan.h"

namespace tyndall::skin {

/// The maps of one surface, from the finest to a sixteenth of its width. Alpha is the chart's number, 0 = nothing.
class LobeBlurs {
 public:
    static constexpr int kLevels = 5;
    /// `atlases`: of one mesh, each half as wide as the one before.
    explicit LobeBlurs(const std::array<Atlas, kLevels>& atlases);

    [[nodiscard]] const GpuAtlas& atlas() const { return levels_[0].atlas; }
    /// To be lit: covered texels, alpha as above. It is not the same afterwards.
    [[nodiscard]] const gpu::Texture& light() const { return levels_[0].light; }
    /// What the next run looks at of the finest map: all at first.
    void choose(const ChunkSet& set);
    [[nodiscard]] const ChunkList& chosen() const { return levels_[0].covered; }
    /// `profile` in metres as the atlases have them.
    void run(gpu::ShaderLibrary& shaders, const physics::DiffusionProfile& profile);
    /// What run() made, with gutters.
    [[nodiscard]] const gpu::Texture& result() const { return levels_[0].total; }
    /// Of the last run.
    [[nodiscard]] const LobePlan& plan() const { return plan_; }
    [[nodiscard]] size_t bytes() const;

 private:
    struct Level {
        GpuAtlas atlas;
        gpu::Texture light;  ///< the newest lobe
        gpu::Texture half;   ///< blurred along u
        gpu::Texture total;
        ChunkList covered;       ///< to work on
        ChunkList with_gutters;  ///< the same
        bool begun = false;      ///< `total`, in this run
    };

    void shrink(gpu::ShaderLibrary& shaders, int to) const;
    void blur(gpu::ShaderLibrary& shaders, const LobeBlur& lobe, const glm::vec3& sharp);
    void half_blur(gpu::ShaderLibrary& shaders, const LobeBlur& lobe, const glm::vec3& sharp, bool along_u) const;
    void grow(gpu::ShaderLibrary& shaders, int to, const glm::vec3& sharp);

    std::vector<Level> levels_;
    gpu::Texture kernels_;
    LobeMap map_;
    LobePlan plan_;
    physics::DiffusionProfile planned_;
    bool leans_ = false;
};

/// What blurs look at, or what bilinear lookups within charts do: gutters next to charts, and what pads charts.
enum class Gutters { all, near };
/// Fills a map's gutters.
void fill_gutters(gpu::ShaderLibrary& shaders, const gpu::Texture& map, const GpuAtlas& atlas, Gutters which);

}  // namespace tyndall::skin
