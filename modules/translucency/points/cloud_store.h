#pragma once
/// The clouds of all meshes in use.

#include <memory>
#include <optional>
#include <utility>

#include "body_space.h"
#include "points/gpu_cloud.h"
#include "render/kept.h"
#include "scene/render_scene.h"
#include "translucency_settings.h"

namespace tyndall::translucency {

/// Clouds by mesh, how it is stretched, and their levels.
class CloudStore {
 public:
    /// Made when it is not there: 0.05 to 1 s.
    const GpuCloud& cloud(const Surface& surface, int levels, const PointsSettings& wanted);
    /// The surface's, m2.
    float area(const Surface& surface);
    /// Once a frame.
    void end_frame();

 private:
    struct Cloud {
        std::unique_ptr<GpuCloud> gpu;
        float opening = 0.0f;
        bool interreflection = false;
    };
    Kept<std::pair<ShapeKey, int>, Cloud> clouds_;
    Kept<ShapeKey, std::optional<float>> areas_;  ///< of the stretched mesh's space
};

}  // namespace tyndall::translucency
