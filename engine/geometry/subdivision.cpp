#include "geometry/subdivision.h"

#include <fmt/format.h>
#include <opensubdiv/far/error.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <memory>
#include <mutex>

#include "core/error.h"
#include "core/log.h"
#include "geometry/vertex_split.h"

namespace tyndall {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

constexpr double kMostFaces = 8e6;

/// A value as OpenSubdiv's refiner wants it.
template <class T>
struct Weighted {
    T value{0.0f};
    void Clear() { value = T(0.0f); }
    void AddWithWeight(const Weighted& other, float weight) { value += weight * other.value; }
};
template <class T>
using Values = std::vector<Weighted<T>>;

void route_messages_once() {
    static std::once_flag done;
    std::call_once(done, [] {
        Far::SetErrorCallback([](Far::ErrorType, const char* message) { log::debug("OpenSubdiv: {}", message); });
        Far::SetWarningCallback([](const char* message) { log::debug("OpenSubdiv: {}", message); });
    });
}

using Refiner = std::unique_ptr<Far::TopologyRefiner>;

/// Texture coordinates numbered anew, so that no two vertices share one: parts that lie over each other in the picture
/// are not joined by that.
VertexSplitter<std::uint32_t> own_uvs(const PolygonMesh& control, std::vector<int>& uv_corners) {
    VertexSplitter<std::uint32_t> split(control.positions.size());
    for (size_t i = 0; i < control.uv_corners.size(); ++i)
        uv_corners.push_back(static_cast<int>(split(control.corners[i], control.uv_corners[i])));
    return split;
}

Refiner make_refiner(const PolygonMesh& control, std::span<const int> uv_corners, size_t uv_count, int levels,
                     std::span<const Crease> creases) {
    const std::vector<int> sizes(control.face_sizes.begin(), control.face_sizes.end());
    const std::vector<int> corners(control.corners.begin(), control.corners.end());
    std::vector<int> crease_ends;
    std::vector<float> sharpness;
    for (const Crease& crease : creases) {
        if (std::max(crease.first, crease.second) >= control.positions.size())
            throw Error("a crease names a vertex that is not there");
        crease_ends.insert(crease_ends.end(), {static_cast<int>(crease.first), static_cast<int>(crease.second)});
        sharpness.push_back(std::clamp(crease.sharpness, 0.0f, Sdc::Crease::SHARPNESS_INFINITE));
    }
    Far::TopologyDescriptor::FVarChannel channel;
    channel.numValues = static_cast<int>(uv_count);
    channel.valueIndices = uv_corners.data();

    Far::TopologyDescriptor description;
    description.numVertices = static_cast<int>(control.positions.size());
    description.numFaces = static_cast<int>(sizes.size());
    description.numVertsPerFace = sizes.data();
    description.vertIndicesPerFace = corners.data();
    description.numCreases = static_cast<int>(sharpness.size());
    description.creaseVertexIndexPairs = crease_ends.data();
    description.creaseWeights = sharpness.data();
    if (!uv_corners.empty()) {
        description.numFVarChannels = 1;
        description.fvarChannels = &channel;
    }

    Sdc::Options rules;
    rules.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
    rules.SetFVarLinearInterpolation(Sdc::Options::FVAR_LINEAR_CORNERS_PLUS1);
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    Factory::Options options(Sdc::SCHEME_CATMARK, rules);
    options.validateFullTopology = true;
    Refiner refiner(Factory::Create(description, options));
    if (!refiner)
        throw Error(Diagnostic{{}, "the control mesh cannot be subdivided", "faces that join along whole edges", {}});
    Far::TopologyRefiner::UniformOptions uniform(levels);
    uniform.fullTopologyInLastLevel = true;  // the limit of the last level needs its neighbourhoods
    refiner->RefineUniform(uniform);
    return refiner;
}

/// The surface's points and derivatives at the vertices of the last level.
struct LimitSurface {
    Values<glm::vec3> points, along_u, along_v;
};

LimitSurface limit_surface(const Far::TopologyRefiner& refiner, const std::vector<glm::vec3>& positions) {
    const Far::PrimvarRefiner primvars(refiner);
    Values<glm::vec3> values(positions.size());
    std::ranges::transform(positions, values.begin(), [](const glm::vec3& p) { return Weighted<glm::vec3>{p}; });
    for (int level = 1; level <= refiner.GetMaxLevel(); ++level) {
        Values<glm::vec3> next(static_cast<size_t>(refiner.GetLevel(level).GetNumVertices()));
        primvars.Interpolate(level, values, next);
        values = std::move(next);
    }
    LimitSurface surface{Values<glm::vec3>(values.size()), Values<glm::vec3>(values.size()),
                         Values<glm::vec3>(values.size())};
    primvars.Limit(values, surface.points, surface.along_u, surface.along_v);
    return surface;
}

Values<glm::vec2> limit_uvs(const Far::TopologyRefiner& refiner, Values<glm::vec2> values) {
    const Far::PrimvarRefiner primvars(refiner);
    for (int level = 1; level <= refiner.GetMaxLevel(); ++level) {
        Values<glm::vec2> next(static_cast<size_t>(refiner.GetLevel(level).GetNumFVarValues()));
        primvars.InterpolateFaceVarying(level, values, next);
        values = std::move(next);
    }
    Values<glm::vec2> limit(values.size());
    primvars.LimitFaceVarying(values, limit);
    return limit;
}

void check_size(const PolygonMesh& control, int levels) {
    if (levels < 0 || levels > 8) throw Error(fmt::format("{} levels of subdivision (expected 0 to 8)", levels));
    // A face becomes as many quads as it has corners, and each of those four a level.
    const double faces = levels == 0 ? static_cast<double>(control.face_sizes.size())
                                     : static_cast<double>(control.corners.size()) * std::pow(4.0, levels - 1);
    if (faces > kMostFaces)
        throw Error(fmt::format("{} levels of subdivision make {:.0f} faces (expected at most {:.0f})", levels, faces,
                                kMostFaces));
}

}  // namespace

Mesh subdivide(const PolygonMesh& control, int levels, std::span<const Crease> creases) {
    route_messages_once();
    validate(control, "control mesh");
    check_size(control, levels);
    std::vector<int> uv_corners;
    const VertexSplitter<std::uint32_t> uvs = own_uvs(control, uv_corners);
    const Refiner refiner = make_refiner(control, uv_corners, uvs.sources().size(), levels, creases);
    const LimitSurface surface = limit_surface(*refiner, control.positions);

    PolygonMesh fine;  // vertices of the control mesh that no face uses have no limit: they are dropped by triangulate
    const Far::TopologyLevel& last = refiner->GetLevel(refiner->GetMaxLevel());
    for (size_t i = 0; i < surface.points.size(); ++i) {
        fine.positions.push_back(surface.points[i].value);
        const glm::vec3 normal = glm::cross(surface.along_u[i].value, surface.along_v[i].value);
        const float length = glm::length(normal);
        fine.normals.push_back(length > 0 ? normal / length : glm::vec3(0, 1, 0));
    }
    if (!uv_corners.empty()) {
        Values<glm::vec2> values;
        for (const std::uint32_t uv : uvs.variants()) values.push_back({control.uvs[uv]});
        for (const auto& uv : limit_uvs(*refiner, std::move(values))) fine.uvs.push_back(uv.value);
    }
    for (int face = 0; face < last.GetNumFaces(); ++face) {
        const Far::ConstIndexArray vertices = last.GetFaceVertices(face);
        fine.face_sizes.push_back(static_cast<std::uint32_t>(vertices.size()));
        for (const int vertex : vertices) fine.corners.push_back(static_cast<std::uint32_t>(vertex));
        if (uv_corners.empty()) continue;
        for (const int uv : last.GetFaceFVarValues(face)) fine.uv_corners.push_back(static_cast<std::uint32_t>(uv));
    }
    fine.normal_corners = fine.corners;
    return triangulate(fine, "subdivided mesh");
}

}  // namespace tyndall
