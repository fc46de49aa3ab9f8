#pragma once
/// The techniques on the screen: the irradiance of the light buffers, gathered from pixels around.

#include <memory>
#include <vector>

#include "kernel.h"
#include "render/frame_graph.h"
#include "screen/screen_settings.h"
#include "shading_model.h"

namespace tyndall::skin {

/// Two_gaussians (Livermore 2012, figure 51), separable (Jimenez et al. 2015) and disc (Christensen & Burley 2015).
/// Kernels lie in the plane of the mesh's normal at each pixel, in metres; what is not as far from the pixel as the
/// plane says counts as far as it is.
class ScreenPass final : public Pass {
 public:
    ScreenPass(std::shared_ptr<SkinTables> tables, const SkinSettings& settings);

    [[nodiscard]] std::string_view name() const override { return "skin.screen"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    /// All surfaces in view of one technique and profile.
    struct Group {
        Technique technique{};
        const physics::DiffusionProfile* profile = nullptr;
        float number = 0.0f;  ///< of the profile, in the table
        glm::ivec2 low{0}, high{0};
        float pixel_m = 0.0f;   ///< metres of a pixel where the nearest of them is
        float far = 0.0f;       ///< none of them is farther than this depth
        bool coloured = false;  ///< colour counts where light enters
    };
    /// A kernel made for a group.
    struct Kernel {
        Technique technique{};
        physics::DiffusionProfile profile;
        int count = 0;
        float least_m = 0.0f;
        std::vector<glm::vec4> taps;    ///< rgb weight; w: metres (line), or 0
        std::vector<glm::vec4> places;  ///< xy metres (disc)
    };

    std::vector<Group> groups(PassContext& context) const;
    const Kernel& kernel_of(const Group& group);
    void pack(PassContext& context, const std::vector<Group>& groups);
    const gpu::Program& begin(PassContext& context, gpu::ProgramDesc desc, bool coloured) const;
    void gather(PassContext& context, const Group& group, const Kernel& kernel, int step);
    void average(PassContext& context, const Group& group, const Kernel& kernel);

    std::shared_ptr<SkinTables> tables_;
    const SkinSettings& settings_;
    std::vector<Kernel> kernels_;
};

}  // namespace tyndall::skin
