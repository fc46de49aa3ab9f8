#include <OpenMesh/Core/IO/importer/BaseImporter.hh>
#include <OpenMesh/Core/IO/reader/STLReader.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <cstring>
#include <mutex>
#include <sstream>

#include "core/error.h"
#include "geometry/readers.h"

namespace tyndall {
namespace {

using namespace OpenMesh;

glm::vec3 to_glm(const Vec3f& v) {
    return {v[0], v[1], v[2]};
}

/// Takes what OpenMesh's readers find as it is: no half-edges, which would cost time and refuse surfaces that are not
/// manifold. The rest of the interface is for other kinds of file.
class Collector final : public IO::BaseImporter {
 public:
    PolygonMesh mesh;

    VertexHandle add_vertex(const Vec3f& point) override {
        mesh.positions.push_back(to_glm(point));
        return VertexHandle(static_cast<int>(mesh.positions.size()) - 1);
    }
    VertexHandle add_vertex() override { return add_vertex(Vec3f(0, 0, 0)); }
    FaceHandle add_face(const VHandles& vertices) override {
        mesh.face_sizes.push_back(static_cast<std::uint32_t>(vertices.size()));
        for (const VertexHandle vertex : vertices) mesh.corners.push_back(static_cast<std::uint32_t>(vertex.idx()));
        return FaceHandle(static_cast<int>(mesh.face_sizes.size()) - 1);
    }
    void set_point(VertexHandle, const Vec3f&) override {}
    void set_normal(VertexHandle, const Vec3f&) override {}
    void set_normal(VertexHandle, const Vec3d&) override {}
    void set_texcoord(VertexHandle, const Vec2f&) override {}
    size_t n_vertices() const override { return mesh.positions.size(); }
    size_t n_faces() const override { return mesh.face_sizes.size(); }
    size_t n_edges() const override { return 0; }

    HalfedgeHandle add_edge(VertexHandle, VertexHandle) override { return HalfedgeHandle(); }
    FaceHandle add_face(HalfedgeHandle) override { return FaceHandle(); }
    void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<Vec2f>&) override {}
    void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<Vec3f>&) override {}
    void set_face_texindex(FaceHandle, int) override {}
    void set_halfedge(VertexHandle, HalfedgeHandle) override {}
    void set_color(VertexHandle, const Vec3uc&) override {}
    void set_color(VertexHandle, const Vec4uc&) override {}
    void set_color(VertexHandle, const Vec3f&) override {}
    void set_color(VertexHandle, const Vec4f&) override {}
    void set_status(VertexHandle, const Attributes::StatusInfo&) override {}
    void set_next(HalfedgeHandle, HalfedgeHandle) override {}
    void set_face(HalfedgeHandle, FaceHandle) override {}
    void request_face_texcoords2D() override {}
    void set_texcoord(HalfedgeHandle, const Vec2f&) override {}
    void set_texcoord(VertexHandle, const Vec3f&) override {}
    void set_texcoord(HalfedgeHandle, const Vec3f&) override {}
    void set_status(HalfedgeHandle, const Attributes::StatusInfo&) override {}
    void set_color(EdgeHandle, const Vec3uc&) override {}
    void set_color(EdgeHandle, const Vec4uc&) override {}
    void set_color(EdgeHandle, const Vec3f&) override {}
    void set_color(EdgeHandle, const Vec4f&) override {}
    void set_status(EdgeHandle, const Attributes::StatusInfo&) override {}
    void set_normal(FaceHandle, const Vec3f&) override {}
    void set_normal(FaceHandle, const Vec3d&) override {}
    void set_color(FaceHandle, const Vec3uc&) override {}
    void set_color(FaceHandle, const Vec4uc&) override {}
    void set_color(FaceHandle, const Vec3f&) override {}
    void set_color(FaceHandle, const Vec4f&) override {}
    void set_status(FaceHandle, const Attributes::StatusInfo&) override {}
    void add_texture_information(int, std::string) override {}
};

/// OpenMesh writes to the terminal by itself; what it says names no line and adds nothing to our own messages.
void silence_once() {
    static std::once_flag done;
    std::call_once(done, [] {
        for (mostream* stream : {&omerr(), &omout(), &omlog()}) stream->disable();
    });
}

/// The size that a binary STL must have, from its count of triangles; 0 when there is no room for a count.
size_t binary_size(const std::string& content) {
    std::uint32_t triangles = 0;
    if (content.size() < 84) return 0;
    std::memcpy(&triangles, content.data() + 80, sizeof triangles);  // little-endian, as every machine that we run on
    return 84 + size_t{triangles} * 50;
}

}  // namespace

PolygonMesh read_stl(const std::string& content, const std::string& source) {
    const auto fail = [&](std::string message) { throw Error(Diagnostic{{source}, std::move(message), {}, {}}); };
    // Text begins with "solid", but so do some binary files: those have exactly the size that they say.
    const bool binary = !content.starts_with("solid") || binary_size(content) == content.size();
    if (binary && (binary_size(content) == 0 || content.size() < binary_size(content)))
        fail("the file is truncated, or no STL file");
    if (!binary && content.find("endsolid") == std::string::npos) fail("the file is truncated: it has no 'endsolid'");
    silence_once();
    Collector collector;
    std::istringstream stream(content);
    IO::Options options(binary ? IO::Options::Binary : IO::Options::Default);
    bool read = false;
    try {
        read = IO::STLReader().read(stream, collector, options);
    } catch (const std::exception& error) {
        fail(std::string("the file is corrupt: ") + error.what());
    }
    if (!read) fail("the file is corrupt");
    return std::move(collector.mesh);
}

}  // namespace tyndall
