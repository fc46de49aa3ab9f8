#include "geometry/points.h"

#include <cmath>

#include "core/error.h"
#include "geometry/readers.h"

namespace tyndall {

std::vector<Point> read_points(std::string_view content, const std::string& source) {
    const PolygonMesh mesh = read_ply(content, source);
    std::vector<Point> points;
    points.reserve(mesh.positions.size());
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3& place = mesh.positions[i];
        if (!std::isfinite(place.x + place.y + place.z))
            throw Error(Diagnostic{{source}, "point " + std::to_string(i) + " has a place that is no number", {}, {}});
        points.push_back({place, i < mesh.radii.size() ? mesh.radii[i] : 0.0f});
    }
    return points;
}

}  // namespace tyndall
