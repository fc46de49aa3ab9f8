#include "radiance_maps/body_mesh.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace tyndall::translucency {
namespace {

constexpr float kBorderTexels = 2.0f;

/// Rows of a view's turn: right, up, back.
glm::mat3 turn(const glm::vec3& axis) {
    const glm::vec3 helper = std::abs(axis.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 right = glm::normalize(glm::cross(axis, helper));
    return {right, glm::cross(right, axis), -axis};
}

glm::vec4 row(const glm::vec3& direction, float offset) {
    return {direction, offset};
}

MapView perspective(const glm::vec3& eye, const glm::vec3& axis, float tangent, float near) {
    const glm::mat3 frame = turn(axis);
    const auto rows = glm::mat4(row(frame[0] / tangent, -glm::dot(frame[0], eye) / tangent),
                                row(frame[1] / tangent, -glm::dot(frame[1], eye) / tangent), glm::vec4(0, 0, 0, near),
                                row(axis, -glm::dot(axis, eye)));
    return {glm::transpose(rows), eye, true, axis, 2.0f * tangent};
}

}  // namespace

MapView parallel_view(std::span<const glm::vec3> places, const glm::vec3& axis, int resolution) {
    const glm::mat3 frame = turn(axis);
    glm::vec3 low(1e30f), high(-1e30f);
    for (const glm::vec3& place : places) {
        const glm::vec3 seen = place * frame;
        low = glm::min(low, seen);
        high = glm::max(high, seen);
    }
    const glm::vec3 middle = 0.5f * (low + high), size = glm::max(high - low, glm::vec3(1e-6f));
    const float side =
        std::max(size.x, size.y) * float(resolution) / std::max(float(resolution) - 2.0f * kBorderTexels, 1.0f);
    const float depth = 1.02f * size.z;
    const auto rows = glm::mat4(row(2.0f / side * frame[0], -2.0f / side * middle.x),
                                row(2.0f / side * frame[1], -2.0f / side * middle.y),
                                row(frame[2] / depth, 0.5f - middle.z / depth), glm::vec4(0, 0, 0, 1));
    return {glm::transpose(rows), glm::vec3(0.0f), false, axis, side};
}

MapView perspective_view(const glm::vec3& eye, const glm::vec3& middle, float radius) {
    const float distance = glm::distance(eye, middle);
    const float tangent = 1.02f * radius / std::sqrt(std::max(distance * distance - radius * radius, 1e-12f));
    return perspective(eye, (middle - eye) / distance, tangent, 0.5f * (distance - radius));
}

MapView cube_view(const glm::vec3& eye, int face, float radius) {
    glm::vec3 axis(0.0f);
    axis[face / 2] = face % 2 == 0 ? 1.0f : -1.0f;
    return perspective(eye, axis, 1.0f, 1e-3f * radius);
}

BodyMesh::BodyMesh(const Mesh& mesh) : index_count_(int(mesh.indices.size())) {
    std::vector<std::array<glm::vec3, 2>> vertices(mesh.positions.size());
    for (size_t i = 0; i < vertices.size(); ++i)
        vertices[i] = {mesh.positions[i], i < mesh.normals.size() ? mesh.normals[i] : glm::vec3(0, 1, 0)};
    vertices_ = gpu::Buffer(std::span<const std::array<glm::vec3, 2>>(vertices), "translucency.maps.vertices");
    indices_ = gpu::Buffer(std::span<const uint32_t>(mesh.indices), "translucency.maps.indices");
    glCreateVertexArrays(1, &vertex_array_);
    for (GLuint i = 0; i < 6; ++i) {
        glEnableVertexArrayAttrib(vertex_array_, i);
        glVertexArrayAttribBinding(vertex_array_, i, i < 2 ? 0 : 1);
    }
    glVertexArrayAttribFormat(vertex_array_, 0, 3, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribFormat(vertex_array_, 1, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3));
    glVertexArrayAttribFormat(vertex_array_, 2, 3, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribFormat(vertex_array_, 3, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3));
    glVertexArrayAttribFormat(vertex_array_, 4, 3, GL_FLOAT, GL_FALSE, 2 * sizeof(glm::vec3));
    glVertexArrayAttribFormat(vertex_array_, 5, 3, GL_FLOAT, GL_FALSE, 3 * sizeof(glm::vec3));
    glVertexArrayVertexBuffer(vertex_array_, 0, vertices_.name(), 0, 2 * sizeof(glm::vec3));
    glVertexArrayElementBuffer(vertex_array_, indices_.name());
}

BodyMesh::~BodyMesh() {
    glDeleteVertexArrays(1, &vertex_array_);
}

void BodyMesh::draw(const gpu::Buffer& own) const {
    glVertexArrayVertexBuffer(vertex_array_, 1, own.name(), 0, 4 * sizeof(glm::vec3));
    glBindVertexArray(vertex_array_);
    glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

}  // namespace tyndall::translucency
