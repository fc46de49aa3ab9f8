#pragma once
/// What the renderer makes ready once a frame, for every pass.

#include <glm/mat4x4.hpp>
#include <memory>

#include "gpu/gpu.h"
#include "gpu/shader_library.h"
#include "scene/render_scene.h"

namespace tyndall {

class Seams;
class GpuScene;
class ShadowMaps;
class Settings;
class LightBuffer;

/// The uniform block "FrameBlock" of render/shaders/frame.glsl: keep both the same.
struct FrameBlock {
    glm::mat4 view;        ///< world to view
    glm::mat4 projection;  ///< view to clip, reversed-Z with infinite far plane: depth = near / -z_view
    glm::mat4 view_projection;
    glm::mat4 inverse_view_projection;
    glm::mat4 previous_view_projection;
    glm::vec4 eye_near;               ///< xyz eye in the world, w near plane in metres
    glm::vec4 size_time;              ///< width, height, time in seconds (z), frame number (w, wraps at 1024)
    glm::vec4 tan_half_fov_exposure;  ///< x: tan(fov/2) * aspect, y: tan(fov/2), z: exposure, w: unused
};

/// ShadowView of render/shaders/lights.glsl.
struct GpuShadowView {
    glm::mat4 page_from_world;  ///< to u, v of a page of the shadow maps and depth
    glm::vec4 rectangle;        ///< low and high uv of the view, less half a texel
    glm::vec4
        texel_page_fades;  ///< metres a texel covers (perspective: at 1 m), page, 1 = a cascade that ends in the scene
};

/// An element of the storage block "Lights" of render/shaders/lights.glsl, one per RenderScene light, same order; and
/// the uniform block "Light" of programs that look at one light a draw.
struct GpuLight {
    glm::vec4 position_range;     ///< xyz in the world, w range (0 = none)
    glm::vec4 direction_kind;     ///< xyz travel direction, w LightKind as float
    glm::vec4 right_cos_outer;    ///< xyz local +X, w cos(outer angle)
    glm::vec4 up_cos_inner;       ///< xyz local +Y, w cos(inner angle)
    glm::vec4 intensity_profile;  ///< rgb colour times cd or lux, w SpotProfile as float
    glm::vec4 gobo;  ///< x layer of the gobo array or -1, y z half size in metres (directional) or tan(outer) (spot), w
                     ///< source size
    glm::vec4 shadow;  ///< x number of views, 0 = not shadowed; y 1 = it makes no highlights
    GpuShadowView views[6];
    glm::vec4 padding[5];  ///< to a multiple of 256 bytes, at which uniform blocks may begin
};

static_assert(sizeof(GpuLight) % 256 == 0);

/// References that live for one frame.
struct Frame {
    const RenderScene& scene;
    gpu::ShaderLibrary& shaders;
    Seams& seams;
    GpuScene& gpu_scene;  ///< meshes, textures, materials on the GPU
    ShadowMaps& shadow_maps;
    const Settings& settings;  ///< renderer's and modules' settings by name
    const FrameBlock& block;
    const gpu::Buffer& frame_block;  ///< bind as "FrameBlock"
    const LightBuffer& lights;       ///< and their gobos
};

/// Binds FrameBlock, Lights, the shadow maps and gobos where the program has them.
void bind_frame(const gpu::Program& program, Frame& frame);
/// Binds one light of the scene for the next draw of a program that defines ONE_LIGHT (render/shaders/lights.glsl).
void bind_light(const gpu::Program& program, const Frame& frame, size_t light);

}  // namespace tyndall
