#include "geometry/ray_mesh.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace tyndall {

std::vector<glm::vec3> cosine_directions(int count) {
    std::vector<glm::vec3> directions;
    for (int i = 0; i < count; ++i) {
        const float share = (float(i) + 0.5f) / float(count), radius = std::sqrt(share);
        const float angle = float(i) * std::numbers::pi_v<float> * (3.0f - std::sqrt(5.0f));
        directions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), std::sqrt(1.0f - share));
    }
    return directions;
}

glm::mat3 frame_about(const glm::vec3& normal, float turn) {
    const glm::vec3 x =
        glm::normalize(glm::cross(normal, std::abs(normal.x) < 0.7f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0)));
    const glm::vec3 turned = std::cos(turn) * x + std::sin(turn) * glm::cross(normal, x);
    return {turned, glm::cross(normal, turned), normal};
}

struct RayMesh::Scene {
    std::unique_ptr<RTCDeviceTy, decltype(&rtcReleaseDevice)> device{rtcNewDevice(nullptr), &rtcReleaseDevice};
    std::unique_ptr<RTCSceneTy, decltype(&rtcReleaseScene)> scene{rtcNewScene(device.get()), &rtcReleaseScene};
};

RayMesh::RayMesh(const Mesh& mesh) : scene_(std::make_unique<Scene>()) {
    const std::unique_ptr<RTCGeometryTy, decltype(&rtcReleaseGeometry)> geometry(
        rtcNewGeometry(scene_->device.get(), RTC_GEOMETRY_TYPE_TRIANGLE), &rtcReleaseGeometry);
    auto* positions = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), mesh.positions.size()));
    auto* indices = static_cast<uint32_t*>(rtcSetNewGeometryBuffer(
        geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(uint32_t), mesh.triangle_count()));
    for (size_t i = 0; i < mesh.positions.size(); ++i)
        for (int c = 0; c < 3; ++c) positions[3 * i + size_t(c)] = mesh.positions[i][c];
    std::copy_n(mesh.indices.begin(), 3 * mesh.triangle_count(), indices);
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometry(scene_->scene.get(), geometry.get());
    rtcCommitScene(scene_->scene.get());
}

RayMesh::~RayMesh() = default;

std::optional<RayMesh::Hit> RayMesh::cast(const glm::vec3& from, const glm::vec3& direction, float farthest) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit hit{};
    hit.ray = {from.x, from.y, from.z, 0.0f, direction.x, direction.y, direction.z, 0.0f, farthest, ~0u, 0, 0};
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_->scene.get(), &context, &hit);
    if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    const glm::vec3 normal(hit.hit.Ng_x, hit.hit.Ng_y, hit.hit.Ng_z);
    return Hit{hit.ray.tfar, glm::dot(normal, direction) < 0.0f};
}

}  // namespace tyndall
