#include "reference/geometry.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/error.h"

namespace tyndall::reference {
namespace {

[[noreturn]] void no_memory() {
    throw Error("there is not enough memory to trace this scene's triangles");
}

RTCRay embree_ray(const Ray& ray, RayMask mask) {
    RTCRay out;
    out.org_x = ray.origin.x, out.org_y = ray.origin.y, out.org_z = ray.origin.z;
    out.dir_x = ray.direction.x, out.dir_y = ray.direction.y, out.dir_z = ray.direction.z;
    out.tnear = 0.0f;
    out.tfar = ray.far_m;
    out.time = 0.0f;
    out.mask = static_cast<uint32_t>(mask);
    out.id = out.flags = 0;
    return out;
}

}  // namespace

Geometry::Geometry(const std::vector<Surface>& surfaces, const std::vector<RayMask>& masks) {
    device_ = rtcNewDevice(nullptr);
    if (!device_) no_memory();
    scene_ = rtcNewScene(device_);
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
    placed_.resize(surfaces.size());
    for (size_t i = 0; i < surfaces.size(); ++i) {
        const Mesh& mesh = surfaces[i].mesh->mesh;
        Placed& placed = placed_[i];
        placed.mesh = &mesh;
        const glm::mat3 linear(surfaces[i].transform);
        const float determinant = glm::determinant(linear);
        if (mesh.indices.empty() || determinant == 0.0f) continue;
        placed.side = determinant < 0.0f ? -1.0f : 1.0f;
        placed.normal_matrix = glm::transpose(glm::inverse(linear));
        placed.tangent_matrix = linear;
        placed.positions.reserve(mesh.positions.size() + 1);
        for (const glm::vec3& p : mesh.positions) {
            placed.positions.emplace_back(surfaces[i].transform * glm::vec4(p, 1.0f));
            bounds_.add(placed.positions.back());
        }
        placed.positions.emplace_back(0.0f);  // Embree reads 16 bytes at the last vertex
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, placed.positions.data(), 0,
                                   sizeof(glm::vec3), mesh.positions.size());
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.indices.data(), 0,
                                   3 * sizeof(uint32_t), mesh.triangle_count());
        rtcSetGeometryMask(geometry, static_cast<uint32_t>(masks[i]));
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(scene_, geometry, static_cast<unsigned>(i));
        rtcReleaseGeometry(geometry);
    }
    rtcCommitScene(scene_);
    if (rtcGetDeviceError(device_) != RTC_ERROR_NONE) no_memory();
}

Geometry::~Geometry() {
    if (scene_) rtcReleaseScene(scene_);
    if (device_) rtcReleaseDevice(device_);
}

bool Geometry::intersect(const Ray& ray, RayMask mask, Hit& hit) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit query;
    query.ray = embree_ray(ray, mask);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_, &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
    hit = {query.ray.tfar, query.hit.geomID, query.hit.primID, {query.hit.u, query.hit.v}};
    return true;
}

bool Geometry::occluded(const Ray& ray, RayMask mask) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay query = embree_ray(ray, mask);
    rtcOccluded1(scene_, &context, &query);
    return query.tfar < 0.0f;
}

void Geometry::corners(uint32_t surface, uint32_t triangle, glm::vec3 out[3]) const {
    const Placed& placed = placed_[surface];
    for (size_t k = 0; k < 3; ++k) out[k] = placed.positions[placed.mesh->indices[3 * size_t{triangle} + k]];
}

float Geometry::area(uint32_t surface, uint32_t triangle) const {
    glm::vec3 p[3];
    corners(surface, triangle, p);
    return 0.5f * glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
}

SurfacePoint Geometry::flat_point(const Hit& hit) const {
    glm::vec3 p[3];
    corners(hit.surface, hit.triangle, p);
    SurfacePoint point;
    point.position =
        p[0] * (1.0f - hit.barycentric.x - hit.barycentric.y) + p[1] * hit.barycentric.x + p[2] * hit.barycentric.y;
    point.geometric_normal = glm::normalize(placed_[hit.surface].side * glm::cross(p[1] - p[0], p[2] - p[0]));
    return point;
}

SurfacePoint Geometry::point(const Hit& hit) const {
    return point_on(hit.surface, hit.triangle, hit.barycentric);
}

SurfacePoint Geometry::point_on(uint32_t surface, uint32_t triangle, glm::vec2 barycentric) const {
    const Placed& placed = placed_[surface];
    const Mesh& mesh = *placed.mesh;
    const uint32_t* index = &mesh.indices[3 * size_t{triangle}];
    const float w[3] = {1.0f - barycentric.x - barycentric.y, barycentric.x, barycentric.y};
    const auto mixed = [&](const auto& values) {
        return values[index[0]] * w[0] + values[index[1]] * w[1] + values[index[2]] * w[2];
    };
    glm::vec3 p[3];
    corners(surface, triangle, p);
    SurfacePoint point;
    point.position = p[0] * w[0] + p[1] * w[1] + p[2] * w[2];
    const glm::vec3 face = placed.side * glm::cross(p[1] - p[0], p[2] - p[0]);
    const float size = glm::length(face);
    if (size > 0.0f) point.geometric_normal = face / size;
    point.normal = point.geometric_normal;
    if (!mesh.normals.empty()) {
        const glm::vec3 n = placed.normal_matrix * mixed(mesh.normals);
        const float length = glm::length(n);
        if (length > 0.0f) point.normal = n / length;
        if (glm::dot(point.normal, point.geometric_normal) < 0.0f) point.normal = point.geometric_normal;
    }
    if (!mesh.tangents.empty()) {
        const glm::vec4 mean = mixed(mesh.tangents);
        const glm::vec3 t = placed.tangent_matrix * glm::vec3(mean);
        const glm::vec3 flat = t - point.normal * glm::dot(t, point.normal);
        const float length = glm::length(flat);
        if (length > 0.0f) point.tangent = glm::vec4(flat / length, placed.side * (mean.w < 0.0f ? -1.0f : 1.0f));
    }
    if (!mesh.uv0.empty()) point.uv[0] = point.uv[1] = mixed(mesh.uv0);
    if (!mesh.uv1.empty()) point.uv[1] = mixed(mesh.uv1);
    return point;
}

glm::vec3 offset_origin(const SurfacePoint& point, const glm::vec3& direction) {
    constexpr float kNearZero = 1.0f / 32.0f, kFloatScale = 1.0f / 65536.0f, kIntScale = 256.0f;
    const glm::vec3 n =
        glm::dot(direction, point.geometric_normal) < 0.0f ? -point.geometric_normal : point.geometric_normal;
    glm::vec3 out;
    for (int i = 0; i < 3; ++i) {
        const float p = point.position[i];
        const auto steps = static_cast<int32_t>(kIntScale * n[i]);
        const int32_t moved = std::bit_cast<int32_t>(p) + (p < 0.0f ? -steps : steps);
        out[i] = std::abs(p) < kNearZero ? p + kFloatScale * n[i] * kNearZero : std::bit_cast<float>(moved);
    }
    return out;
}

}  // namespace tyndall::reference
