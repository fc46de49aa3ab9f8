#pragma once
/// What fog that a lamp lights up sends onto surfaces, beside what the lamp sends itself (Sun et al. 2005, 5.2).

#include "gpu/gpu.h"
#include "media_buffer.h"
#include "media_settings.h"

namespace tyndall::participating_media {

/// Provider of the indirect-light seam. Lambert and Phong surfaces, point lights that the solver analytic renders, even
/// media taken as without end and as scattering alike in all directions. Off unless the scene asks for it: it is light
/// of the second order, which the other solvers leave out.
class SurfaceGlow {
 public:
    /// Sets what shaders/analytic/surface_glow.glsl declares.
    void bind(const gpu::Program& program, const RenderScene& scene, const MediaBuffer& media,
              const MediaSettings& settings);

 private:
    gpu::Texture table_;
};

}  // namespace tyndall::participating_media
