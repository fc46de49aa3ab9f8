#include "render/gpu_scene.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <glm/gtc/matrix_inverse.hpp>
#include <map>
#include <tuple>

#include "render/frustum.h"
#include "render/material_table.h"
#include "render/mesh_cache.h"
#include "render/seams.h"
#include "render/texture_cache.h"

namespace tyndall {
namespace {

/// The struct SurfaceRecord of render/shaders/surfaces.glsl.
struct SurfaceRecord {
    glm::mat4 world_from_local;
    glm::mat4 previous_world_from_local;
    glm::vec4 normal_from_local[3];  ///< columns of the inverse transpose; w of the first: number of the surface
};

constexpr uint32_t kNoMaterial = 0xffffffff;
/// What a depth pass needs to know of a material.
constexpr uint32_t kDepthFeatures = kAlphaMask | kBaseColourMap | kUvTransform;

struct Item {
    const Surface* surface = nullptr;
    const GpuMesh* mesh = nullptr;
    uint32_t material = 0;
    bool mirrored = false;  ///< the transform turns front faces into back faces
};

/// One instance to draw: what it shares with others in front, so that sorting groups them.
struct Visible {
    uint32_t features = 0;
    uint32_t material = kNoMaterial;
    const GpuMesh* mesh = nullptr;
    bool two_sided = false;
    bool mirrored = false;
    uint32_t item = 0;
    float distance2 = 0.0f;

    [[nodiscard]] auto batch() const { return std::tie(features, material, mesh, two_sided, mirrored); }
};

/// Instances of one call.
struct Batch {
    size_t first = 0;
    size_t count = 0;
    float distance2 = 0.0f;
};

/// `number` from 1 on, as RenderScene has the surfaces: what gbuffer_surface tells of a pixel.
SurfaceRecord record_of(const Surface& surface, float number) {
    const glm::mat3 normal = glm::inverseTranspose(glm::mat3(surface.transform));
    return {surface.transform,
            surface.previous_transform,
            {glm::vec4(normal[0], number), glm::vec4(normal[1], 0.0f), glm::vec4(normal[2], 0.0f)}};
}

float distance2(const Bounds& box, const glm::vec3& eye) {
    const glm::vec3 nearest = glm::clamp(eye, box.low, box.high) - eye;
    return glm::dot(nearest, nearest);
}

/// FNV-1a.
uint64_t hash_bytes(uint64_t hash, const void* data, size_t bytes) {
    const auto* at = static_cast<const unsigned char*>(data);
    for (size_t i = 0; i < bytes; ++i) hash = (hash ^ at[i]) * 0x100000001b3ull;
    return hash;
}

}  // namespace

struct GpuScene::Implementation {
    explicit Implementation(gpu::ShaderLibrary& library) : shaders(library) {}

    gpu::ShaderLibrary& shaders;
    MeshCache meshes;
    TextureCache textures;
    MaterialTable materials;
    std::vector<Item> items;
    std::vector<SurfaceRecord> records;
    gpu::Buffer surfaces;
    gpu::Buffer instances;  // indices into "Surfaces", appended by each draw of the frame
    size_t instances_used = 0;
    size_t triangles = 0;
    Bounds bounds;
    std::map<std::pair<std::string, uint32_t>, gpu::ProgramDesc> programs;
    std::vector<Visible> visible;
    std::vector<Batch> batches;
    std::vector<uint32_t> order;

    void collect_visible(const DrawView& view, bool depth_only);
    void make_batches();
    size_t upload_order();
    const gpu::Program& program(const SurfaceShader& shader, uint32_t features);
    size_t draw(const DrawView& view, const SurfaceShader& shader, bool depth_only,
                const std::function<void(const gpu::Program&)>& bind);
};

void GpuScene::Implementation::collect_visible(const DrawView& view, bool depth_only) {
    const Frustum frustum(view.clip_from_world);
    visible.clear();
    for (size_t i = 0; i < items.size(); ++i) {
        const Item& item = items[i];
        if (view.casters_only && !item.surface->casts_shadow) continue;
        if (!frustum.touches(item.surface->bounds)) continue;
        Visible one;
        one.features = materials.features(item.material);
        if ((one.features & view.features) != view.features) continue;
        if (depth_only) one.features = (one.features & kAlphaMask) != 0 ? one.features & kDepthFeatures : 0;
        one.material = depth_only && one.features == 0 ? kNoMaterial : item.material;
        one.mesh = item.mesh;
        one.two_sided = view.casters_only || materials.double_sided(item.material);
        one.mirrored = item.mirrored;
        one.item = uint32_t(i);
        one.distance2 = distance2(item.surface->bounds, view.eye);
        visible.push_back(one);
    }
}

void GpuScene::Implementation::make_batches() {
    std::ranges::sort(visible, [](const Visible& a, const Visible& b) {
        if (a.batch() != b.batch()) return a.batch() < b.batch();
        return std::tie(a.distance2, a.item) < std::tie(b.distance2, b.item);
    });
    batches.clear();
    order.clear();
    for (size_t i = 0; i < visible.size(); ++i) {
        if (i == 0 || visible[i].batch() != visible[i - 1].batch()) batches.push_back({i, 0, visible[i].distance2});
        ++batches.back().count;
        order.push_back(visible[i].item);
    }
    // programs together, and within them the nearest batch first
    std::ranges::sort(batches, [this](const Batch& a, const Batch& b) {
        const Visible& first = visible[a.first];
        const Visible& second = visible[b.first];
        return std::tie(first.features, a.distance2, first.item) < std::tie(second.features, b.distance2, second.item);
    });
}

size_t GpuScene::Implementation::upload_order() {
    const size_t needed = (instances_used + order.size()) * sizeof(uint32_t);
    if (needed > instances.size()) {  // draws under way keep the old buffer alive
        instances = gpu::Buffer(2 * needed, nullptr, "Instances");
        instances_used = 0;
    }
    const size_t first = instances_used;
    instances.update(first * sizeof(uint32_t), order.size() * sizeof(uint32_t), order.data());
    instances_used += order.size();
    return first;
}

const gpu::Program& GpuScene::Implementation::program(const SurfaceShader& shader, uint32_t features) {
    const auto [found, is_new] = programs.try_emplace({shader.name, features});
    gpu::ProgramDesc& desc = found->second;
    if (is_new) {
        desc.name = shader.name;
        desc.vertex = "render/shaders/surface.vert";
        desc.fragment = shader.fragment;
        desc.defines = feature_defines(features);
        desc.defines.insert(desc.defines.end(), shader.defines.begin(), shader.defines.end());
    }
    return shaders.program(desc);
}

size_t GpuScene::Implementation::draw(const DrawView& view, const SurfaceShader& shader, bool depth_only,
                                      const std::function<void(const gpu::Program&)>& bind) {
    collect_visible(view, depth_only);
    if (visible.empty()) return 0;
    make_batches();
    const size_t first_instance = upload_order();
    meshes.bind(instances);
    const gpu::Program* current = nullptr;
    size_t drawn = 0;
    for (const Batch& batch : batches) {
        const Visible& head = visible[batch.first];
        if (const gpu::Program& wanted = program(shader, head.features); &wanted != current) {
            current = &wanted;
            wanted.use();
            wanted.set("clip_from_world", view.clip_from_world);
            wanted.block("Surfaces", surfaces);
            if (bind) bind(wanted);
        }
        if (head.material != kNoMaterial) materials.bind(head.material, *current, textures);
        (head.two_sided ? glDisable : glEnable)(GL_CULL_FACE);
        glFrontFace(head.mirrored ? GL_CW : GL_CCW);
        meshes.bind(*head.mesh);
        glDrawElementsInstancedBaseInstance(GL_TRIANGLES, head.mesh->index_count, GL_UNSIGNED_INT, nullptr,
                                            GLsizei(batch.count), GLuint(first_instance + batch.first));
        drawn += batch.count * size_t(head.mesh->index_count) / 3;
    }
    glDisable(GL_CULL_FACE);
    glFrontFace(GL_CCW);
    triangles += drawn;
    return drawn;
}

GpuScene::GpuScene(gpu::ShaderLibrary& shaders) : self_(std::make_unique<Implementation>(shaders)) {}
GpuScene::~GpuScene() = default;

void GpuScene::update(const RenderScene& scene, const Seams& seams) {
    static const Material kPlain;
    Implementation& self = *self_;
    self.meshes.collect();
    self.textures.collect();
    self.materials.begin();
    self.items.clear();
    self.records.clear();
    self.instances_used = 0;
    self.triangles = 0;
    self.bounds = {};
    for (const Surface& surface : scene.surfaces) {
        if (!surface.mesh) continue;
        const GpuMesh& mesh = self.meshes.get(*surface.mesh);
        if (mesh.index_count == 0) continue;
        const Material& material = surface.material ? *surface.material : kPlain;
        const uint32_t index = self.materials.add(material, seams, self.textures);
        const bool mirrored = glm::determinant(glm::mat3(surface.transform)) < 0.0f;
        self.items.push_back({&surface, &mesh, index, mirrored});
        self.records.push_back(record_of(surface, float(&surface - scene.surfaces.data() + 1)));
        self.bounds.merge(surface.bounds);
    }
    self.materials.upload();
    const size_t bytes = self.records.size() * sizeof(SurfaceRecord);
    if (bytes > self.surfaces.size()) self.surfaces = gpu::Buffer(bytes + bytes / 2, nullptr, "Surfaces");
    if (bytes > 0) self.surfaces.update(0, bytes, self.records.data());
}

size_t GpuScene::draw(const DrawView& view, const SurfaceShader& shader,
                      const std::function<void(const gpu::Program&)>& bind) {
    return self_->draw(view, shader, false, bind);
}

size_t GpuScene::draw_depth(const DrawView& view) {
    static const SurfaceShader kDepth{"depth", "render/shaders/surface_depth.frag", {"DEPTH_ONLY"}};
    return self_->draw(view, kDepth, true, {});
}

void GpuScene::draw_mesh(const MeshAsset& mesh) {
    const GpuMesh& gpu_mesh = self_->meshes.get(mesh);
    if (gpu_mesh.index_count == 0 || self_->instances.name() == 0) return;
    self_->meshes.bind(self_->instances);
    self_->meshes.bind(gpu_mesh);
    glDrawElements(GL_TRIANGLES, gpu_mesh.index_count, GL_UNSIGNED_INT, nullptr);
    self_->triangles += static_cast<size_t>(gpu_mesh.index_count) / 3;
}

uint64_t GpuScene::casters_hash(const glm::mat4& clip_from_world) const {
    const Frustum frustum(clip_from_world);
    uint64_t hash = 0xcbf29ce484222325ull;
    for (const Item& item : self_->items) {
        if (!item.surface->casts_shadow || !frustum.touches(item.surface->bounds)) continue;
        const bool masked = (self_->materials.features(item.material) & kAlphaMask) != 0;
        const uint64_t ids[2] = {item.surface->mesh->id, masked ? self_->materials.id(item.material) : 0};
        hash = hash_bytes(hash, ids, sizeof ids);
        hash = hash_bytes(hash, &item.surface->transform, sizeof item.surface->transform);
    }
    return hash;
}

const gpu::Texture& GpuScene::texture(const TextureAsset& asset) {
    return self_->textures.get(asset);
}

const Bounds& GpuScene::bounds() const {
    return self_->bounds;
}

size_t GpuScene::triangles_drawn() const {
    return self_->triangles;
}

}  // namespace tyndall
