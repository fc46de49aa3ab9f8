#pragma once
/// Light gathered in three buffers (light_diffuse, light_specular_a, light_specular_b), before materials are known.
///
/// The buffers are 32-bit floats: sunlight of 1e5 lux on a smooth surface is beyond the 65504 of 16 bits, and what is
/// stored stays in cd/m2 and lux for every module, without an exposure to undo.

#include <map>
#include <span>
#include <string>
#include <vector>

#include "gpu/gpu.h"
#include "render/frame_graph.h"
#include "render/light_programs.h"
#include "render/light_volumes.h"
#include "render/seams.h"
#include "render/specular_table.h"

namespace tyndall {

/// Creates the light buffers with what the indirect-light seam says, times the occlusion of the surface.
class IndirectPass final : public Pass {
 public:
    IndirectPass(Seams& seams, SpecularTableTexture& table) : seams_(seams), table_(table) {}
    [[nodiscard]] std::string_view name() const override { return "indirect"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    Seams& seams_;
    SpecularTableTexture& table_;
};

/// Adds every light, drawn as the volume that it can reach: only pixels inside are shaded. Shading models other than
/// "standard" are in the program where surfaces of theirs may be seen, and nowhere else.
class LightsPass final : public Pass {
 public:
    explicit LightsPass(Seams& seams) : seams_(seams) {}
    ~LightsPass() override;
    [[nodiscard]] std::string_view name() const override { return "lights"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    /// Programs of one choice of shading models.
    struct Programs {
        explicit Programs(const std::vector<std::string>& defines);
        LightPrograms volume, screen;
    };

    void create_volumes();
    void add_lights(PassContext& context, const std::vector<std::string>& defines,
                    std::span<const PixelRectangle> where);
    void draw(const gpu::Program& program, const glm::mat4& clip_from_world, const LightVolume& volume);

    Seams& seams_;
    std::map<std::vector<std::string>, Programs> programs_;  ///< by defines
    gpu::Buffer vertices_;                                   // the sphere, then the cone
    int sphere_vertices_ = 0;
    int cone_vertices_ = 0;
    unsigned int vertex_array_ = 0;
};

}  // namespace tyndall
