#include "render/mesh_cache.h"

#include <epoxy/gl.h>

#include <vector>

namespace tyndall {
namespace {

enum Binding : GLuint { kPositions, kAttributes, kInstances };

GpuMesh upload(const MeshAsset& asset) {
    const Mesh& mesh = asset.mesh;
    std::vector<MeshVertex> vertices(mesh.positions.size(), MeshVertex{{0, 1, 0}, 0, {1, 0, 0, 1}, {0, 0}, {0, 0}});
    for (size_t i = 0; i < vertices.size(); ++i) {
        if (i < mesh.normals.size()) vertices[i].normal = mesh.normals[i];
        if (i < mesh.curvatures.size()) vertices[i].curvature = mesh.curvatures[i];
        if (i < mesh.tangents.size()) vertices[i].tangent = mesh.tangents[i];
        if (i < mesh.uv0.size()) vertices[i].uv0 = mesh.uv0[i];
        if (i < mesh.uv1.size()) vertices[i].uv1 = mesh.uv1[i];
    }
    GpuMesh result;
    result.index_count = static_cast<int>(mesh.indices.size());
    if (result.index_count == 0) return result;
    result.positions = gpu::Buffer(std::span<const glm::vec3>(mesh.positions), asset.name);
    result.attributes = gpu::Buffer(std::span<const MeshVertex>(vertices), asset.name);
    result.indices = gpu::Buffer(std::span<const uint32_t>(mesh.indices), asset.name);
    return result;
}

}  // namespace

MeshCache::~MeshCache() {
    if (vertex_array_ != 0) glDeleteVertexArrays(1, &vertex_array_);
}

void MeshCache::create_format() {
    glCreateVertexArrays(1, &vertex_array_);
    const auto attribute = [this](GLuint index, GLint components, GLuint offset, Binding binding) {
        glEnableVertexArrayAttrib(vertex_array_, index);
        glVertexArrayAttribFormat(vertex_array_, index, components, GL_FLOAT, GL_FALSE, offset);
        glVertexArrayAttribBinding(vertex_array_, index, binding);
    };
    attribute(0, 3, 0, kPositions);
    attribute(1, 3, offsetof(MeshVertex, normal), kAttributes);
    attribute(2, 4, offsetof(MeshVertex, tangent), kAttributes);
    attribute(3, 2, offsetof(MeshVertex, uv0), kAttributes);
    attribute(4, 2, offsetof(MeshVertex, uv1), kAttributes);
    attribute(6, 1, offsetof(MeshVertex, curvature), kAttributes);
    glEnableVertexArrayAttrib(vertex_array_, 5);
    glVertexArrayAttribIFormat(vertex_array_, 5, 1, GL_UNSIGNED_INT, 0);
    glVertexArrayAttribBinding(vertex_array_, 5, kInstances);
    glVertexArrayBindingDivisor(vertex_array_, kInstances, 1);
}

const GpuMesh& MeshCache::get(const MeshAsset& asset) {
    auto [found, is_new] = entries_.try_emplace(asset.id);
    if (is_new) found->second = upload(asset);
    found->second.last_used = frame_;
    return found->second;
}

void MeshCache::bind(const gpu::Buffer& instances) {
    if (vertex_array_ == 0) create_format();
    glBindVertexArray(vertex_array_);
    glVertexArrayVertexBuffer(vertex_array_, kInstances, instances.name(), 0, sizeof(uint32_t));
}

void MeshCache::bind(const GpuMesh& mesh) {
    glVertexArrayVertexBuffer(vertex_array_, kPositions, mesh.positions.name(), 0, sizeof(glm::vec3));
    glVertexArrayVertexBuffer(vertex_array_, kAttributes, mesh.attributes.name(), 0, sizeof(MeshVertex));
    glVertexArrayElementBuffer(vertex_array_, mesh.indices.name());
}

void MeshCache::collect() {
    ++frame_;
    std::erase_if(entries_, [this](const auto& item) { return frame_ - item.second.last_used > kKeptFrames; });
}

}  // namespace tyndall
