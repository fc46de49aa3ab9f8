#pragma once
/// The technique tsm: translucent shadow maps (Dachsbacher & Stamminger 2003).

#include <memory>
#include <string>
#include <vector>

#include "body_size.h"
#include "interior_buffers.h"
#include "light_view.h"
#include "render/frame_graph.h"
#include "render/kept.h"
#include "render/light_programs.h"
#include "seen_surface.h"
#include "translucency_settings.h"
#include "tsm/level_kernels.h"

namespace tyndall::translucency {

class TsmPass final : public Pass {
 public:
    TsmPass(std::shared_ptr<TechniquePlan> plan, const TranslucencySettings& settings);

    [[nodiscard]] std::string_view name() const override { return "translucency.tsm"; }
    void declare(PassDeclaration& declaration) override;
    void execute(PassContext& context) override;

 private:
    /// What one light sees of an object.
    struct LightMap {
        LightView view;  ///< not whole: the light is too near
        LightViewBlock view_block;
        gpu::Texture light, spread;
        std::string made_from;  ///< all that it depends on, byte by byte
        KernelKey kernel_key;
        LevelKernels kernels;
        gpu::Texture kernel_table;
        int first_level = 0;
    };
    struct Object {
        InteriorBuffers interior;
        std::vector<LightMap> maps;
        BodySize size;
        glm::vec3 scale{1.0f};  ///< so that as much leaves the body as flat ground would send out
        float reach = 0.0f;     ///< metres beyond which hardly any light comes
        bool too_near = false;  ///< some light is, and that has been said
    };
    /// A surface in its frame.
    struct Drawn {
        const Surface& surface;
        const SeenSurface& seen;
        Object& object;
    };

    Object& object_of(const Surface& surface);
    void render(PassContext& context, const Drawn& drawn);
    void see(PassContext& context, const Drawn& drawn, size_t light);
    void draw_entries(PassContext& context, const Drawn& drawn, const LightMap& map);
    void make_kernels(const Drawn& drawn, LightMap& map) const;
    void gather(PassContext& context, const Drawn& drawn, size_t light, bool keeps);
    [[nodiscard]] int texels() const;

    std::shared_ptr<TechniquePlan> plan_;
    const TranslucencySettings& settings_;
    KeptOfSurfaces<Object> objects_;
    LightPrograms light_programs_, gather_programs_;
    gpu::Texture entries_, depths_;  ///< of the map that is being made
    gpu::Framebuffer framebuffer_;
};

}  // namespace tyndall::translucency
