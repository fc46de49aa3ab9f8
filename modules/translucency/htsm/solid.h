#pragma once
/// A translucent solid on the GPU, for the technique htsm.

#include <glm/mat4x4.hpp>
#include <memory>

#include "gpu/gpu.h"
#include "htsm/object_grid.h"
#include "phase_table.h"
#include "scene/render_scene.h"
#include "translucency_settings.h"

namespace tyndall::translucency {

/// The uniform block "Solid" of shaders/htsm/object.glsl: keep both the same.
struct SolidBlock {
    glm::mat4 unit_from_world, world_from_unit;
    glm::vec4 scattering_eta;    ///< rgb 1/m, w index of refraction
    glm::vec4 extinction_guide;  ///< rgb 1/m, w the channels' mean
    glm::vec4 voxel_cast;        ///< x metres a voxel, y 1: the object is in the shadow maps
    glm::vec4 transport;         ///< rgb transport colour, w transport distance in metres
    glm::vec4 most_phase;        ///< rgb the phase function's largest value, 1/sr
};

/// Shopf's transport colour and distance (2006, 4.3.3), which he leaves to the user: how far light comes in diffusion
/// before 1/e is left of the channels' mean, and what is left of each channel there. w is in metres, at most `longest`;
/// `chosen` above 0 is the distance.
[[nodiscard]] glm::vec4 transport_of(const ScatteringInterior& interior, float longest, float chosen = 0.0f);

/// What an object is looked up in. Made anew in parts, when what they are made from changes.
class Solid {
 public:
    /// False when the mesh encloses nothing: there is nothing to march.
    bool update(const Surface& surface, double time_s, const HtsmSettings& settings);
    void bind(const gpu::Program& program) const;

    [[nodiscard]] float radius_m() const { return radius_m_; }
    [[nodiscard]] const SolidBlock& block() const { return block_; }
    [[nodiscard]] const glm::ivec3& size() const { return grid_.size; }
    /// Another number each time that the grid or what is in it changes.
    [[nodiscard]] uint64_t version() const { return version_; }

 private:
    void make_grid(const Surface& surface, int resolution);
    void make_density(const Surface& surface, double time_s);
    void make_block(const Surface& surface, float transport_distance);

    ObjectGrid grid_;
    uint64_t mesh_ = 0;
    int resolution_ = 0;
    DensityField density_;
    glm::mat4 transform_{0.0f};
    double time_s_ = 0.0;
    PhaseTexture phase_;
    SolidBlock block_{};
    float radius_m_ = 0.0f;
    bool flat_ = false;  ///< and that has been said
    uint64_t version_ = 0;
    gpu::Texture inside_, densities_;
    gpu::Buffer buffer_;
};

}  // namespace tyndall::translucency
