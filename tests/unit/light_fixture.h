#pragma once
/// A small world of boxes and planes under lights, and what shaders say about light at chosen points.

#include <epoxy/gl.h>

#include <glm/gtc/matrix_transform.hpp>

#include "gpu_fixture.h"
#include "render/gpu_scene.h"
#include "render/light_buffer.h"
#include "render/shadow_maps.h"

namespace tyndall {

/// A point to ask about; a normal of 0 means a point in a volume.
struct ProbePoint {
    glm::vec4 position{0.0f};
    glm::vec4 normal{0.0f};
};
struct ProbeResult {
    glm::vec4 transmittance{0.0f};
    glm::vec4 irradiance{0.0f};
};

class LightTest : public GpuTest {
 protected:
    void SetUp() override {
        GpuTest::SetUp();
        shaders_ = std::make_unique<gpu::ShaderLibrary>();
        seams_ = std::make_unique<Seams>(*shaders_);
        gpu_scene_ = std::make_unique<GpuScene>(*shaders_);
        shadow_maps_ = std::make_unique<ShadowMaps>();
        lights_ = std::make_unique<LightBuffer>();
        shaders_->set_text("test/light_probe.comp", R"(
#include "render/shaders/shadow_maps.glsl"
layout(local_size_x = 8) in;
struct Point { vec4 position; vec4 normal; };
struct Result { vec4 transmittance; vec4 irradiance; };
layout(std430) readonly buffer Points { Point points[]; };
layout(std430) writeonly buffer Results { Result results[]; };
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= uint(points.length())) return;
    vec3 p = points[i].position.xyz, to_light;
    uint light = uint(points[i].position.w);
    results[i].irradiance = vec4(light_irradiance(light, p, to_light), 1.0);
    results[i].transmittance = vec4(shadow_maps_transmittance(light, p, points[i].normal.xyz), 1.0);
})");
        look_from({0.0f, 1.7f, 10.0f}, {0.0f, 1.0f, 0.0f});
    }
    void TearDown() override {
        frame_block_ = {};
        lights_.reset();
        shadow_maps_.reset();
        gpu_scene_.reset();
        seams_.reset();
        shaders_.reset();
        GpuTest::TearDown();
    }

    void look_from(glm::vec3 eye, glm::vec3 at) {
        scene_.camera.transform = glm::inverse(glm::lookAt(eye, at, {0, 1, 0}));
    }

    /// A mesh of quads, each given by a corner and two sides that turn counter-clockwise seen from outside.
    static std::shared_ptr<const MeshAsset> quads(const std::vector<std::array<glm::vec3, 3>>& sides) {
        static uint64_t ids = 1'000'000;
        auto asset = std::make_shared<MeshAsset>();
        asset->id = ++ids;
        Mesh& mesh = asset->mesh;
        for (const auto& [corner, u, v] : sides) {
            const auto base = static_cast<uint32_t>(mesh.positions.size());
            for (const glm::vec3& at : {corner, corner + u, corner + u + v, corner + v}) {
                mesh.positions.push_back(at);
                mesh.normals.push_back(glm::normalize(glm::cross(u, v)));
                mesh.uv0.emplace_back(0.0f);
                mesh.bounds.add(at);
            }
            for (const uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(base + i);
        }
        return asset;
    }
    static std::shared_ptr<const MeshAsset> plane(float half) {
        return quads({{glm::vec3(-half, 0, half), glm::vec3(2 * half, 0, 0), glm::vec3(0, 0, -2 * half)}});
    }
    static std::shared_ptr<const MeshAsset> box() {
        const glm::vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), o(-0.5f);
        return quads({{o, y, x}, {o, z, y}, {o, x, z}, {o + z, x, y}, {o + x, y, z}, {o + y, z, x}});
    }
    Surface& add(std::shared_ptr<const MeshAsset> mesh, const glm::mat4& transform = glm::mat4(1.0f)) {
        Surface surface;
        surface.mesh = std::move(mesh);
        surface.transform = surface.previous_transform = transform;
        surface.bounds = surface.mesh->mesh.bounds.transformed(transform);
        scene_.surfaces.push_back(std::move(surface));
        return scene_.surfaces.back();
    }
    Surface& add_box(glm::vec3 centre, glm::vec3 size) {
        return add(box(), glm::scale(glm::translate(glm::mat4(1.0f), centre), size));
    }
    static void move(Surface& surface, glm::vec3 by) {
        surface.transform = glm::translate(glm::mat4(1.0f), by) * surface.transform;
        surface.bounds = surface.mesh->mesh.bounds.transformed(surface.transform);
    }
    Light& add_light(LightKind kind, glm::vec3 from, glm::vec3 at, int size = 1024) {
        Light light;
        light.kind = kind;
        const glm::vec3 up = std::abs(glm::normalize(at - from).y) > 0.99f ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0);
        light.transform = glm::inverse(glm::lookAt(from, at, up));
        light.intensity = glm::vec3(100.0f);
        light.shadow = {.enabled = true, .size = size};
        scene_.lights.push_back(light);
        return scene_.lights.back();
    }

    /// What the renderer does before and in the shadow pass.
    void render() {
        const float aspect = 16.0f / 9.0f, half = std::tan(0.5f * scene_.camera.vertical_fov);
        gpu_scene_->update(scene_, *seams_);
        shadow_maps_->prepare(scene_, gpu_scene_->bounds(), {half * aspect, half});
        lights_->update(scene_, *shadow_maps_, *gpu_scene_, *shaders_);
        glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);  // as the frame graph does before each pass
        shadow_maps_->render(*gpu_scene_);
        FrameBlock block{};
        block.view = glm::inverse(scene_.camera.transform);
        block.eye_near = glm::vec4(glm::vec3(scene_.camera.transform[3]), scene_.camera.near_m);
        block.size_time = {1280.0f, 720.0f, 0.0f, 0.0f};
        block.tan_half_fov_exposure = {half * aspect, half, 1.0f, 0.0f};
        frame_block_ = gpu::Buffer(sizeof block, &block, "FrameBlock");
    }
    /// All points must name the same light. Programs may look at all lights or at the one that is bound: both are asked
    /// and must say the same.
    std::vector<ProbeResult> probe(const std::vector<ProbePoint>& points) {
        const std::vector<ProbeResult> all = probe(points, {});
        const std::vector<ProbeResult> one = probe(points, {"ONE_LIGHT"});
        for (size_t i = 0; i < points.size(); ++i) {
            EXPECT_NEAR(all[i].transmittance.x, one[i].transmittance.x, 1e-5f);
            EXPECT_NEAR(all[i].irradiance.x, one[i].irradiance.x, 1e-4f * (1.0f + all[i].irradiance.x));
        }
        return all;
    }
    std::vector<ProbeResult> probe(const std::vector<ProbePoint>& points, const std::vector<std::string>& defines) {
        const gpu::Buffer in(std::span<const ProbePoint>(points), "Points");
        gpu::Buffer out(points.size() * sizeof(ProbeResult), nullptr, "Results");
        const gpu::Program& program =
            shaders_->program({.name = "light_probe", .compute = "test/light_probe.comp", .defines = defines});
        program.use();
        lights_->bind(program);
        lights_->bind_one(program, static_cast<size_t>(points[0].position.w));
        shadow_maps_->bind(program);
        program.block("FrameBlock", frame_block_);
        program.block("Points", in);
        program.block("Results", out);
        glDispatchCompute(static_cast<GLuint>((points.size() + 7) / 8), 1, 1);
        glMemoryBarrier(GL_ALL_BARRIER_BITS);
        std::vector<ProbeResult> results(points.size());
        out.read(0, results.size() * sizeof(ProbeResult), results.data());
        return results;
    }
    float lit(glm::vec3 p, glm::vec3 n, size_t light = 0) {
        return probe({{glm::vec4(p, static_cast<float>(light)), glm::vec4(n, 0.0f)}})[0].transmittance.x;
    }
    glm::vec3 irradiance(glm::vec3 p, size_t light = 0) {
        return glm::vec3(probe({{glm::vec4(p, static_cast<float>(light)), glm::vec4(0.0f)}})[0].irradiance);
    }

    RenderScene scene_;
    std::unique_ptr<gpu::ShaderLibrary> shaders_;
    std::unique_ptr<Seams> seams_;
    std::unique_ptr<GpuScene> gpu_scene_;
    std::unique_ptr<ShadowMaps> shadow_maps_;
    std::unique_ptr<LightBuffer> lights_;
    gpu::Buffer frame_block_;
};

}  // namespace tyndall
