#pragma once
/// The clouds of all meshes in use.

#include <cstdint>
#include <map>
#include <memory>
#include <tuple>
#include <utility>

#include "points/gpu_cloud.h"
#include "scene/render_scene.h"

namespace tyndall::translucency {

/// For how many frames what nobody uses is kept.
constexpr uint64_t kKeptFrames = 120;

/// Clouds by mesh, how it is stretched, and their levels.
class CloudStore {
 public:
    /// Made when it is not there: 0.05 to 1 s.
    const GpuCloud& cloud(const Surface& surface, int levels, float opening);
    /// The surface's, m2.
    float area(const Surface& surface);
    /// Once a frame.
    void forget_unused();

 private:
    using Shape = std::tuple<uint64_t, float, float, float>;
    struct Cloud {
        std::unique_ptr<GpuCloud> gpu;
        uint64_t last_used = 0;
        float opening = 0.0f;
    };
    struct Area {
        float area = 0.0f;  ///< of the stretched mesh's space
        uint64_t last_used = 0;
    };

    std::map<std::pair<Shape, int>, Cloud> clouds_;
    std::map<Shape, Area> areas_;
    uint64_t frame_ = 0;
};

}  // namespace tyndall::translucency
