#pragma once
/// Techniques that turn the light of an object's pixels into other light: what they share, in compute shaders
/// (shaders/pixel.glsl) and in fragment shaders (shaders/seen.glsl).

#include <vector>

#include "interior_buffers.h"
#include "render/frame_graph.h"
#include "render/pixel_rectangle.h"
#include "render/specular_table.h"
#include "translucent_surfaces.h"

namespace tyndall::translucency {

/// A surface in a frame.
struct SeenSurface {
    const Surface* surface = nullptr;
    float number = 0.0f;  ///< in gbuffer_surface
    PixelRectangle pixels;
};

/// Surfaces with a size that may be in the picture, of a technique.
[[nodiscard]] std::vector<SeenSurface> seen_surfaces(TechniquePlan& plan, Technique technique, PassContext& context);

/// Whether any light comes from elsewhere than from lights: probes, the sky, or what other modules provide, such as the
/// glow of a flame.
[[nodiscard]] bool has_indirect_light(const Frame& frame);

/// In Pass::declare.
void declare_pixels(PassDeclaration& declaration);
/// After program.use(): what shaders/lit_pixel.glsl reads of pixels of any surface.
void bind_lit_pixels(const gpu::Program& program, PassContext& context, const PixelRectangle& pixels);
/// And what shaders/pixel.glsl reads beyond that.
void bind_numbered_pixels(const gpu::Program& program, PassContext& context, const SeenSurface& seen);
/// After program.use(): the pixels' targets and the interior.
void bind_pixels(const gpu::Program& program, PassContext& context, const SeenSurface& seen,
                 const InteriorBuffers& interior);
/// In groups of 8x8; what is written is seen by what follows.
void dispatch_pixels(glm::ivec2 size);
/// The same where an invocation looks at a column of pixels (shaders/pixel.glsl).
void dispatch_columns(glm::ivec2 size);
/// What shaders/seen.glsl reads, for techniques that shade in fragments; `number` as above.
void bind_seen(const gpu::Program& program, PassContext& context, const Surface& surface, float number,
               SpecularTableTexture& table);
/// Takes away what the pixels had and begins with light from all around, which is taken to leave where it entered.
/// `elsewhere`: that of lights is not.
void begin_pixels(PassContext& context, const SeenSurface& seen, const InteriorBuffers& interior, bool elsewhere);

}  // namespace tyndall::translucency
