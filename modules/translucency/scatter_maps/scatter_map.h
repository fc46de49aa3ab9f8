#pragma once
/// What a light sees of a solid: the subsurface scatter map (Ki 2009; Livermore 2012, 4.3).

#include <string>

#include "gpu/gpu.h"
#include "light_view.h"
#include "render/frame_graph.h"
#include "render/light_programs.h"

namespace tyndall::translucency {

/// Of one light and one solid; drawn when either, or what stands in the light's way, has changed.
class ScatterMap {
 public:
    /// `state`: all that the map depends on. `bind` is called after use() of the program that draws what enters.
    void update(PassContext& context, size_t light, const Surface& surface, int size, std::string state,
                const std::function<void(const gpu::Program&)>& bind, LightPrograms& programs);
    void bind(const gpu::Program& program) const;
    [[nodiscard]] static size_t bytes(int size);

 private:
    void make_textures(int size);
    void draw_exits(PassContext& context, const Surface& surface) const;
    void draw_entries(PassContext& context, size_t light, const Surface& surface,
                      const std::function<void(const gpu::Program&)>& bind, LightPrograms& programs);

    std::string made_from_;
    LightView view_;
    LightViewBlock view_block_;
    gpu::Texture
        exits_;  ///< minus the nearest depth at which light leaves, the farthest, the farthest at which it enters
    gpu::Texture light_;  ///< rgb what enters, lux across the light's way; a: 1
    gpu::Texture way_;    ///< direction inside, as long as the refracted way is for one metre of the straight; depth
    gpu::Texture flux_;   ///< rgb what leaves of it scattered more than once, before it is spread; a: luminance, depth
    gpu::Texture depth_;
    gpu::Framebuffer exit_target_, entry_target_;
};

}  // namespace tyndall::translucency
