#include "thickness/thickness_grid.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "geometry/surface_points.h"
#include "geometry/thickness.h"
#include "splats.h"

namespace tyndall::translucency {
namespace {

constexpr int kLevels = 13;  ///< 2 to this power points
constexpr int kRays = 32;

}  // namespace

ThicknessGrid make_thickness_grid(const Mesh& mesh, int resolution) {
    const std::vector<SurfacePoint> points = sample_surface(mesh, kLevels);
    ThicknessGrid grid;
    if (points.empty()) return grid;
    const InwardRays rays(mesh, kRays);
    std::vector<float> found(points.size());
    parallel_for(0, points.size(), 256, [&](size_t first, size_t last) {
        for (size_t i = first; i < last; ++i) found[i] = rays.thickness(points[i].position, points[i].normal);
    });
    const SurfaceGrid place(mesh.bounds, resolution);
    grid.box = place.box;
    grid.size = place.size;
    Splats<float> splats(place);
    double sum = 0.0;
    for (size_t i = 0; i < points.size(); ++i) {
        splats.add(points[i].position, found[i], 1.0f);
        sum += double(found[i]);
    }
    splats.widen();
    splats.widen();
    grid.thickness = splats.means();
    grid.mean = float(sum / double(points.size()));
    return grid;
}

}  // namespace tyndall::translucency
