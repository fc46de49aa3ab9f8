#include "points/points_pass.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "core/log.h"
#include "render/draw_state.h"
#include "render/frame.h"
#include "render/frustum.h"
#include "render/seams.h"

namespace tyndall::translucency {
namespace {

constexpr uint64_t kKeptFrames = 120;
const std::vector<std::string> kBegin{"BEGIN"}, kNone, kDirections{"DIRECTIONS"};
constexpr int kBalanceRounds = 6;
constexpr uint32_t kGroup = PointCloud::kCluster;

const gpu::Program& compute(PassContext& context, std::string_view shader, std::vector<std::string> defines = {}) {
    const gpu::Program& program =
        context.frame().shaders.program({.name = fmt::format("translucency.points.{}", shader),
                                         .compute = fmt::format("translucency/points/{}.comp", shader),
                                         .defines = std::move(defines)});
    program.use();
    bind_frame(program, context.frame());
    return program;
}

/// In groups of a cluster each.
void dispatch(uint32_t points) {
    glDispatchCompute((points + kGroup - 1) / kGroup, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

/// How a transform stretches the mesh's axes, over the most, in steps of a fiftieth so that little changes keep the
/// cloud.
glm::vec3 shape_of(const glm::mat4& transform) {
    const glm::vec3 scale(glm::length(transform[0]), glm::length(transform[1]), glm::length(transform[2]));
    const glm::vec3 steps = glm::round(50.0f * glm::log(scale / std::max({scale.x, scale.y, scale.z})));
    return glm::exp(steps / 50.0f);
}

glm::mat4 world_from_cloud(const Surface& surface, const GpuCloud& cloud) {
    return surface.transform * glm::scale(glm::mat4(1.0f), 1.0f / cloud.shape);
}

/// Metres of a unit of the cloud's.
float scale_of(const Surface& surface, const GpuCloud& cloud) {
    return std::cbrt(std::abs(glm::determinant(glm::mat3(world_from_cloud(surface, cloud)))));
}

/// Of a disc as large as a point's piece, metres.
float piece_radius(const Surface& surface, const GpuCloud& cloud) {
    return std::max(cloud.spacing * scale_of(surface, cloud), 1e-9f) / std::sqrt(std::numbers::pi_v<float>);
}

/// The mesh with its axes stretched.
Mesh stretched(const Mesh& mesh, const glm::vec3& shape) {
    Mesh made;
    made.positions = mesh.positions;
    made.normals = mesh.normals;
    made.indices = mesh.indices;
    for (glm::vec3& position : made.positions) position *= shape;
    for (glm::vec3& normal : made.normals) normal = glm::normalize(normal / shape);
    made.bounds = bounds_of(made.positions);
    return made;
}

/// Cofactors: they turn an area's vector as the matrix turns its sides.
glm::mat3 area_matrix(const glm::mat4& transform) {
    const glm::mat3 m(transform);
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

void bind_points(const gpu::Program& program, const Surface& surface, const GpuCloud& cloud, const GpuObject& object) {
    const auto bind = [&](std::string_view name, const gpu::Texture& texture) {
        program.texture(name, texture, {.filter = gpu::Filter::nearest});  // a program has one of the two
        program.image(name, texture, 0, true);
    };
    bind("node_places", object.node_places);
    bind("node_fluxes", object.node_fluxes);
    bind("node_directions", object.node_directions);
    bind("point_scales", object.point_scales);
    bind("point_light", object.point_light);
    bind("pieces", cloud.pieces);
    bind("lists", cloud.lists);
    program.block("ListBegins", cloud.list_begins);
    object.interior.bind(program);
    program.set("point_count", cloud.points);
    const glm::mat4 world = world_from_cloud(surface, cloud);
    program.set("world_from_local", world);
    const glm::mat3 areas = area_matrix(world);
    program.set("areas_from_local", glm::determinant(glm::mat3(surface.transform)) < 0.0f ? -areas : areas);
}

}  // namespace

PointsPass::PointsPass(std::shared_ptr<TechniquePlan> plan, const TranslucencySettings& settings)
    : plan_(std::move(plan)),
      settings_(settings),
      light_programs_({.name = "translucency.points.light", .compute = "translucency/points/light.comp"}),
      directional_light_programs_({.name = "translucency.points.directional_light",
                                   .compute = "translucency/points/light.comp",
                                   .defines = kDirections}) {}

bool PointsPass::directional() const {
    return settings_.model == Model::directional;
}

PointsPass::~PointsPass() {
    if (vertex_array_ != 0) glDeleteVertexArrays(1, &vertex_array_);
}

void PointsPass::declare(PassDeclaration& declaration) {
    declaration.stage(Stage::diffusion)
        .reads("scene_depth", "where the surfaces are seen")
        .reads("gbuffer_normal", "toward the eye")
        .updates("light_diffuse", "light that leaves translucent surfaces in place of what arrives there");
}

void PointsPass::execute(PassContext& context) {
    ++frame_;
    const RenderScene& scene = context.frame().scene;
    const Frustum frustum(context.frame().block.view_projection);
    if (settings_.enabled)
        for (const size_t index : plan_->surfaces(scene, Technique::points))
            if (frustum.touches(scene.surfaces[index].bounds)) render(context, scene.surfaces[index]);
    forget_unused();
}

void PointsPass::render(PassContext& context, const Surface& surface) {
    const float volume = std::abs(glm::determinant(glm::mat3(surface.transform)));
    if (!(volume > 0.0f) || !std::isfinite(volume)) return;
    const GpuCloud& cloud = cloud_of(surface);
    if (cloud.points == 0) return;
    Object& object = object_of(surface, cloud);
    if (!object.balanced) balance(context, surface, cloud, *object.gpu);
    object.balanced = true;
    light(context, surface, cloud, *object.gpu);
    sum(context, surface, cloud, *object.gpu);
    gather(context, surface, cloud, *object.gpu);
    draw(context, surface, cloud, *object.gpu);
}

const GpuCloud& PointsPass::cloud_of(const Surface& surface) {
    const glm::vec3 shape = shape_of(surface.transform);
    Cloud& cloud = clouds_[{surface.mesh->id, shape.x, shape.y, shape.z}];
    cloud.last_used = frame_;
    const PointsSettings& wanted = settings_.points;
    if (!cloud.gpu || cloud.levels != wanted.levels || cloud.opening != wanted.opening) {
        const auto begun = std::chrono::steady_clock::now();
        const Mesh& mesh = surface.mesh->mesh;
        const PointCloud made = shape == glm::vec3(1.0f)
                                    ? make_point_cloud(mesh, wanted.levels, wanted.opening)
                                    : make_point_cloud(stretched(mesh, shape), wanted.levels, wanted.opening);
        cloud.gpu = std::make_unique<GpuCloud>(made, shape);
        cloud.levels = wanted.levels;
        cloud.opening = wanted.opening;
        log::info("translucency: {}: {} points, {} to gather from on average, {:.1f} MB, {:.2f} s", surface.mesh->name,
                  made.points.size(),
                  made.points.empty() ? 0 : made.lists.size() * PointCloud::kCluster / made.points.size(),
                  double(cloud.gpu->bytes()) / 1048576.0,
                  std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count());
    }
    return *cloud.gpu;
}

PointsPass::Object& PointsPass::object_of(const Surface& surface, const GpuCloud& cloud) {
    const uint64_t entity = uint64_t(surface.entity.index) << 32u | surface.entity.generation;
    ObjectKey key{entity, surface.mesh->id, 0};
    while (objects_[key].last_used == frame_) ++std::get<2>(key);
    Object& object = objects_[key];
    object.last_used = frame_;
    if (!object.gpu || object.cloud != &cloud || object.directional != directional()) {
        object.gpu = std::make_unique<GpuObject>(cloud, directional());
        object.cloud = &cloud;
        object.directional = directional();
        object.balanced = false;
    }
    const float radius = piece_radius(surface, cloud);
    if (object.gpu->interior.update({optics_of(*surface.interior), settings_.model, settings_.scaling, radius,
                                     cloud.radius * scale_of(surface, cloud)}))
        object.balanced = false;
    return object;
}

void PointsPass::forget_unused() {
    const auto old = [&](const auto& entry) { return entry.second.last_used + kKeptFrames < frame_; };
    std::erase_if(objects_, old);
    std::erase_if(clouds_, old);
}

void PointsPass::balance(PassContext& context, const Surface& surface, const GpuCloud& cloud, const GpuObject& object) {
    const int rounds = settings_.scaling == Scaling::exact ? kBalanceRounds : 0;
    for (int round = 0; round <= rounds; ++round) {
        const gpu::Program& even = compute(context, "even", round == 0 ? kBegin : kNone);
        bind_points(even, surface, cloud, object);
        dispatch(cloud.points);
        if (round == rounds) break;
        sum(context, surface, cloud, object);
        const gpu::Program& step = compute(context, "balance");
        bind_points(step, surface, cloud, object);
        dispatch(cloud.points);
    }
}

/// What arrives at the points, from the lights and from all around.
void PointsPass::light(PassContext& context, const Surface& surface, const GpuCloud& cloud, const GpuObject& object) {
    Frame& frame = context.frame();
    const gpu::Program& place = compute(context, "place", directional() ? kDirections : kNone);
    frame.seams.bind(Seam::indirect_light, place, context);
    bind_points(place, surface, cloud, object);
    dispatch(cloud.points);
    LightPrograms& programs = directional() ? directional_light_programs_ : light_programs_;
    programs.begin();
    for (size_t i = 0; i < frame.scene.lights.size(); ++i) {
        const gpu::Program& program = programs.use(frame, i, [&](const gpu::Program& fresh) {
            frame.seams.bind(Seam::light_transmittance, fresh, context);
            bind_points(fresh, surface, cloud, object);
        });
        program.set("light_index", unsigned(i));
        dispatch(cloud.points);
    }
}

void PointsPass::sum(PassContext& context, const Surface& surface, const GpuCloud& cloud, const GpuObject& object) {
    const gpu::Program& program = compute(context, "sum", directional() ? kDirections : kNone);
    bind_points(program, surface, cloud, object);
    for (int level = 0; level < cloud.levels; level += 3) {
        const int levels = std::min(3, cloud.levels - level);
        const uint32_t nodes = cloud.points >> uint32_t(level + levels);
        for (int i = 0; i <= levels; ++i) program.set(fmt::format("level_begins[{}]", i), cloud.first(level + i));
        program.set("eighths", nodes);
        program.set("levels", unsigned(levels));
        dispatch(nodes);
    }
}

void PointsPass::gather(PassContext& context, const Surface& surface, const GpuCloud& cloud, const GpuObject& object) {
    const gpu::Program& program = compute(context, directional() ? "gather_directional" : "gather");
    bind_points(program, surface, cloud, object);
    program.set("piece_radius", piece_radius(surface, cloud));
    dispatch(cloud.points);
}

void PointsPass::draw(PassContext& context, const Surface& surface, const GpuCloud& cloud, const GpuObject& object) {
    static const gpu::ProgramDesc kDesc{.name = "translucency.points.surface",
                                        .vertex = "translucency/points/surface.vert",
                                        .fragment = "translucency/points/surface.frag"};
    if (vertex_array_ == 0) {
        glCreateVertexArrays(1, &vertex_array_);
        for (GLuint i = 0; i < 3; ++i) {
            glEnableVertexArrayAttrib(vertex_array_, i);
            glVertexArrayAttribBinding(vertex_array_, i, 0);
        }
        glVertexArrayAttribFormat(vertex_array_, 0, 3, GL_FLOAT, GL_FALSE, offsetof(PointCloud::Vertex, position));
        glVertexArrayAttribIFormat(vertex_array_, 1, 2, GL_UNSIGNED_INT, offsetof(PointCloud::Vertex, points));
        glVertexArrayAttribFormat(vertex_array_, 2, 4, GL_UNSIGNED_BYTE, GL_TRUE,
                                  offsetof(PointCloud::Vertex, weights));
    }
    glVertexArrayVertexBuffer(vertex_array_, 0, cloud.vertices.name(), 0, sizeof(PointCloud::Vertex));
    glVertexArrayElementBuffer(vertex_array_, cloud.indices.name());
    context.bind_targets();
    Frame& frame = context.frame();
    const gpu::Program& program = frame.shaders.program(kDesc);
    program.use();
    bind_frame(program, frame);
    object.interior.bind(program);
    for (const char* target : {"scene_depth", "gbuffer_normal"})
        program.texture(target, context.texture(target), {.filter = gpu::Filter::nearest});
    program.texture("point_light", object.point_light, {.filter = gpu::Filter::nearest});
    program.set("world_from_local", world_from_cloud(surface, cloud));
    program.set("clip_from_world", frame.block.view_projection);
    const DrawState state(DepthState::off, BlendState::attenuate_add);
    const bool mirrored = glm::determinant(glm::mat3(surface.transform)) < 0.0f;
    glEnable(GL_CULL_FACE);
    glFrontFace(mirrored ? GL_CW : GL_CCW);
    glBindVertexArray(vertex_array_);
    glDrawElements(GL_TRIANGLES, cloud.index_count, GL_UNSIGNED_INT, nullptr);
    glDisable(GL_CULL_FACE);
    glFrontFace(GL_CCW);
}

}  // namespace tyndall::translucency
