#include "geometry/mesh.h"

#include <fmt/format.h>

#include <glm/vector_relational.hpp>

#include "core/error.h"
#include "geometry/polygons.h"

namespace tyndall {

Bounds bounds_of(const std::vector<glm::vec3>& positions) {
    Bounds bounds;
    for (const glm::vec3& p : positions) bounds.add(p);
    return bounds;
}

void validate(const Mesh& mesh, const std::string& source) {
    const auto fail = [&](std::string message) { throw Error(Diagnostic{{source}, std::move(message), {}, {}}); };
    const size_t count = mesh.positions.size();
    if (count == 0 || mesh.indices.empty()) fail("the mesh has no triangles");
    if (mesh.indices.size() % 3 != 0) fail("the number of indices is not a multiple of 3");
    for (const size_t length :
         {mesh.normals.size(), mesh.tangents.size(), mesh.uv0.size(), mesh.uv1.size(), mesh.curvatures.size()})
        if (length != 0 && length != count)
            fail(fmt::format("an attribute has {} values for {} vertices", length, count));
    for (const std::uint32_t index : mesh.indices)
        if (index >= count) fail(fmt::format("a triangle names vertex {} of {}", index, count));
    for (size_t i = 0; i < count; ++i)
        if (glm::any(glm::isnan(mesh.positions[i])) || glm::any(glm::isinf(mesh.positions[i])))
            fail(fmt::format("the position of vertex {} is not finite", i));
}

Mesh load_mesh(const std::filesystem::path& file) {
    Mesh mesh = triangulate(load_polygons(file), file.string());
    if (mesh.normals.empty()) compute_normals(mesh, kDefaultCrease);
    compute_tangents(mesh);
    return mesh;
}

}  // namespace tyndall
