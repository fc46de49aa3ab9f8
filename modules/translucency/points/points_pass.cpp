#include "points/points_pass.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "body_space.h"
#include "points/detail.h"
#include "render/draw_state.h"
#include "render/frame.h"
#include "render/frustum.h"
#include "render/seams.h"
#include "seen_surface.h"

namespace tyndall::translucency {
namespace {

const std::vector<std::string> kBegin{"BEGIN"}, kNone, kDirections{"DIRECTIONS"};
constexpr int kBalanceRounds = 6;
/// So often light that leaves the body meets it again.
constexpr uint32_t kSightRounds = 3;
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

bool has_volume(const Surface& surface) {
    const float volume = std::abs(glm::determinant(glm::mat3(surface.transform)));
    return volume > 0.0f && std::isfinite(volume);
}

glm::mat4 world_from_cloud(const Surface& surface, const GpuCloud& cloud) {
    return world_from_stretched(surface, cloud.shape);
}

/// Metres of a unit of the cloud's.
float scale_of(const Surface& surface, const GpuCloud& cloud) {
    return metres_of_unit(world_from_cloud(surface, cloud));
}

/// Of a disc as large as a point's piece, metres.
float piece_radius(const Surface& surface, const GpuCloud& cloud) {
    return std::max(cloud.spacing * scale_of(surface, cloud), 1e-9f) / std::sqrt(std::numbers::pi_v<float>);
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
    bind("sights", cloud.sights);
    bind("groups", cloud.groups);
    bind("group_blends", cloud.group_blends);
    bind("group_light", object.group_light);
    bind("open_light", object.open_light);
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
        .updates("light_diffuse", "light that leaves translucent surfaces in place of what arrives there")
        .after("translucency.paint_mark");
}

void PointsPass::execute(PassContext& context) {
    const RenderScene& scene = context.frame().scene;
    const Frustum frustum(context.frame().block.view_projection);
    std::vector<const Surface*> seen;
    if (settings_.enabled)
        for (const size_t index : plan_->surfaces(scene, Technique::points))
            if (has_volume(scene.surfaces[index]) && frustum.touches(scene.surfaces[index].bounds))
                seen.push_back(&scene.surfaces[index]);
    const float share = share_of_budget(context, seen);
    for (const Surface* surface : seen) render(context, *surface, share);
    objects_.end_frame();
    clouds_.end_frame();
}

float PointsPass::points_for(PassContext& context, const Surface& surface) {
    return points_worth(surface, clouds_.area(surface), context.frame().block, settings_.points.pixels);
}

float PointsPass::share_of_budget(PassContext& context, const std::vector<const Surface*>& seen) {
    float all = 0.0f;
    const float most = std::ldexp(1.0f, settings_.points.levels);
    for (const Surface* surface : seen) all += std::min(points_for(context, *surface), most);
    return std::min(1.0f, float(settings_.points.most) / std::max(all, 1.0f));
}

void PointsPass::render(PassContext& context, const Surface& surface, float share) {
    Object& object = objects_.of(surface);
    const PointsSettings& wanted = settings_.points;
    const float points = std::min(points_for(context, surface), std::ldexp(1.0f, wanted.levels));
    object.levels = levels_for(share * points, object.levels, wanted.levels);
    const GpuCloud& cloud = clouds_.cloud(surface, object.levels, wanted);
    if (cloud.points == 0) return;
    prepare(object, surface, cloud);
    if (!object.balanced) balance(context, surface, cloud, *object.gpu);
    object.balanced = true;
    light(context, surface, cloud, *object.gpu);
    sum(context, surface, cloud, *object.gpu);
    gather(context, surface, cloud, *object.gpu);
    draw(context, surface, cloud, *object.gpu);
}

void PointsPass::prepare(Object& object, const Surface& surface, const GpuCloud& cloud) const {
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
    object.gpu->interior.paint(plan_->paints().of(surface, settings_.model), surface);
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

/// What arrives at the points, from the lights, from other parts of the body and from all around.
void PointsPass::light(PassContext& context, const Surface& surface, const GpuCloud& cloud, const GpuObject& object) {
    Frame& frame = context.frame();
    const std::vector<std::string>& defines = directional() ? kDirections : kNone;
    const gpu::Program& begin = compute(context, "begin", defines);
    frame.seams.bind(Seam::indirect_light, begin, context);
    bind_points(begin, surface, cloud, object);
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
    const bool sees = cloud.sights.name() != 0;
    for (uint32_t round = 0; sees && round < kSightRounds; ++round)
        for (const char* half : {"emit", "see"}) {
            const gpu::Program& program = compute(context, half);
            bind_points(program, surface, cloud, object);
            dispatch(cloud.points / PointCloud::kSightGroup);
        }
    if (!sees && !has_indirect_light(frame)) return;
    const gpu::Program& around = compute(context, "around", defines);
    bind_points(around, surface, cloud, object);
    around.set("sees", sees ? 1 : 0);
    dispatch(cloud.points);
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
    blend(context, cloud, object);
}

/// Before it is drawn, since a vertex that many triangles share would be blended many times.
void PointsPass::blend(PassContext& context, const GpuCloud& cloud, const GpuObject& object) {
    const gpu::Program& program = compute(context, "blend");
    program.texture("blends", cloud.blends, {.filter = gpu::Filter::nearest});
    program.texture("point_light", object.point_light, {.filter = gpu::Filter::nearest});
    program.image("vertex_light", object.vertex_light, 0, true);
    program.set("vertices", cloud.vertices);
    dispatch(cloud.vertices);
}

void PointsPass::draw(PassContext& context, const Surface& surface, const GpuCloud& cloud, const GpuObject& object) {
    static const gpu::ProgramDesc kDesc{.name = "translucency.points.surface",
                                        .vertex = "translucency/points/surface.vert",
                                        .fragment = "translucency/points/surface.frag"};
    if (vertex_array_ == 0) {
        glCreateVertexArrays(1, &vertex_array_);
        glEnableVertexArrayAttrib(vertex_array_, 0);
        glVertexArrayAttribBinding(vertex_array_, 0, 0);
        glVertexArrayAttribFormat(vertex_array_, 0, 3, GL_FLOAT, GL_FALSE, 0);
    }
    glVertexArrayVertexBuffer(vertex_array_, 0, cloud.positions.name(), 0, sizeof(glm::vec3));
    glVertexArrayElementBuffer(vertex_array_, cloud.indices.name());
    context.bind_targets();
    Frame& frame = context.frame();
    const gpu::Program& program = frame.shaders.program(kDesc);
    program.use();
    bind_frame(program, frame);
    object.interior.bind(program);
    for (const char* target : {"scene_depth", "gbuffer_normal"})
        program.texture(target, context.texture(target), {.filter = gpu::Filter::nearest});
    program.texture("vertex_light", object.vertex_light, {.filter = gpu::Filter::nearest});
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
