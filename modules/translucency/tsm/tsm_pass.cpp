#include "tsm/tsm_pass.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/log.h"
#include "render/draw_state.h"
#include "render/frame.h"
#include "render/light_state.h"
#include "render/seams.h"

namespace tyndall::translucency {
namespace {

/// Looks along a side of each texel of a map, as light.comp has it.
constexpr int kSamples = 2;

/// All levels from the first.
void make_coarser(Frame& frame, const gpu::Texture& light, const gpu::Texture& spread, int texels) {
    static const gpu::ProgramDesc kDesc{.name = "translucency.tsm.coarser", .compute = "translucency/tsm/coarser.comp"};
    const gpu::Program& program = frame.shaders.program(kDesc);
    program.use();
    program.image("light_map", light, 0, true);
    program.image("light_spread", spread, 0, true);
    program.set("map_size", texels);
    for (int level = 1; texels >> level > 0; ++level) {
        program.set("level", level);
        dispatch_pixels(glm::ivec2(texels >> level));
    }
}

}  // namespace

TsmPass::TsmPass(std::shared_ptr<TechniquePlan> plan, const TranslucencySettings& settings)
    : plan_(std::move(plan)),
      settings_(settings),
      light_programs_({.name = "translucency.tsm.light", .compute = "translucency/tsm/light.comp"}),
      gather_programs_({.name = "translucency.tsm.gather", .compute = "translucency/tsm/gather.comp"}) {}

void TsmPass::declare(PassDeclaration& declaration) {
    declare_pixels(declaration);
    declaration.after("translucency.radiance_maps");
}

int TsmPass::texels() const {
    return int(std::bit_floor(unsigned(settings_.tsm.size)));
}

void TsmPass::execute(PassContext& context) {
    if (settings_.enabled)
        for (const SeenSurface& seen : seen_surfaces(*plan_, Technique::tsm, context))
            render(context, {*seen.surface, seen, object_of(*seen.surface)});
    objects_.end_frame();
}

TsmPass::Object& TsmPass::object_of(const Surface& surface) {
    Object& object = objects_.of(surface);
    const bool reshaped = object.size.update(surface.mesh->mesh, glm::mat3(surface.transform));
    const Optics optics = optics_of(*surface.interior);
    const float path = mean_free_path(optics);
    if (object.interior.update({optics, settings_.model, settings_.scaling, path, object.size.radius}) || reshaped) {
        const RadialKernel kernel(optics, settings_.model, Scaling::exact, path);
        object.reach = reach_of(kernel);
        object.scale = settings_.scaling == Scaling::exact
                           ? 1.0f / glm::max(object.size.surface.sent_out(kernel), glm::vec3(1e-3f))
                           : glm::vec3(1.0f);
    }
    object.interior.paint(plan_->paints().of(surface, settings_.model), surface);
    return object;
}

void TsmPass::render(PassContext& context, const Drawn& drawn) {
    const RenderScene& scene = context.frame().scene;
    drawn.object.maps.resize(scene.lights.size());
    for (size_t i = 0; i < scene.lights.size(); ++i) {
        see(context, drawn, i);
        if (drawn.object.maps[i].view.whole) make_kernels(drawn, drawn.object.maps[i]);
    }
    const bool begins = scene.lights.empty() || has_indirect_light(context.frame());
    if (begins) begin_pixels(context, drawn.seen, drawn.object.interior, true);
    gather_programs_.begin();
    for (size_t i = 0; i < scene.lights.size(); ++i) gather(context, drawn, i, begins || i > 0);
}

/// Makes a light's map anew where something has changed.
void TsmPass::see(PassContext& context, const Drawn& drawn, size_t light) {
    Frame& frame = context.frame();
    const Surface& surface = drawn.surface;
    LightMap& map = drawn.object.maps[light];
    std::string state;
    append_light_state(state, frame, light, objects_.frame());
    append_state(state, surface.transform);
    append_state(state, surface.mesh->id);
    append_state(state, drawn.object.size.radius);
    append_state(state, optics_of(*surface.interior));
    append_state(state, settings_.scaling);
    append_state(state, plan_->paints().number(surface, settings_.model));
    append_state(state, texels());
    if (state == map.made_from) return;
    map.made_from = std::move(state);
    map.view = light_view(frame.scene.lights[light], surface.mesh->mesh, surface.transform, texels());
    map.view_block.update(map.view, texels());
    if (!map.view.whole) {
        if (!std::exchange(drawn.object.too_near, true))
            log::info("translucency: {}: a light stands in the body or close to it: its light leaves where it enters",
                      surface.material->name);
        return;
    }
    draw_entries(context, drawn, map);
    if (map.light.name() == 0 || map.light.desc().height != texels()) {
        gpu::TextureDesc desc{
            .format = gpu::Format::rgba32f, .width = texels() + texels() / 2, .height = texels()};  // pyramid.glsl
        map.light = gpu::Texture(desc, "translucency.tsm.light");
        desc.format = gpu::Format::r32f;
        map.spread = gpu::Texture(desc, "translucency.tsm.spread");
    }
    light_programs_.begin();  // other programs have been in use since the last light
    const gpu::Program& program = light_programs_.use(frame, light, [&](const gpu::Program& fresh) {
        frame.seams.bind(Seam::light_transmittance, fresh, context);
        drawn.object.interior.bind(fresh);
    });
    map.view_block.bind(program);
    program.set("world_from_view", glm::inverse(map.view.view_from_world));
    program.set("light_index", unsigned(light));
    program.set("map_size", texels());
    program.texture("entries", entries_, {.filter = gpu::Filter::nearest});
    program.image("light_map", map.light, 0, true);
    program.image("light_spread", map.spread, 0, true);
    dispatch_pixels(glm::ivec2(texels()));
    make_coarser(frame, map.light, map.spread, texels());
}

void TsmPass::draw_entries(PassContext& context, const Drawn& drawn, const LightMap& map) {
    static const gpu::ProgramDesc kDesc{.name = "translucency.tsm.map",
                                        .vertex = "translucency/light_view.vert",
                                        .fragment = "translucency/tsm/map.frag"};
    const int size = kSamples * texels();
    if (entries_.name() == 0 || entries_.desc().width != size) {
        framebuffer_ = {};
        entries_ =
            gpu::Texture({.format = gpu::Format::rgba32f, .width = size, .height = size}, "translucency.tsm.entries");
        depths_ =
            gpu::Texture({.format = gpu::Format::depth32f, .width = size, .height = size}, "translucency.tsm.depths");
        const gpu::Framebuffer::Attachment colour{&entries_, 0, -1};
        framebuffer_ = gpu::Framebuffer(std::span(&colour, 1), {&depths_, 0, -1}, "translucency.tsm");
    }
    framebuffer_.bind();
    framebuffer_.clear_colour(0, glm::vec4(0.0f));
    framebuffer_.clear_depth();
    Frame& frame = context.frame();
    const gpu::Program& program = frame.shaders.program(kDesc);
    program.use();
    map.view_block.bind(program);
    const DrawState state(DepthState::write);
    draw_in(map.view, program, frame.gpu_scene, drawn.surface);
}

void TsmPass::make_kernels(const Drawn& drawn, LightMap& map) const {
    KernelKey key;
    key.optics = optics_of(*drawn.surface.interior);
    key.model = settings_.model;
    key.scaling = settings_.scaling;
    key.scale = drawn.object.scale;
    // in steps: a body or a light that turns keeps its kernels, which take longer to make than the map
    key.farthest_m = std::exp2(
        0.25f * std::ceil(4.0f * std::log2(1.5f * glm::length(drawn.surface.bounds.high - drawn.surface.bounds.low))));
    const float texel = map.view.width_m() / float(texels());
    const glm::vec3 extinction = key.optics.sigma_s_reduced + key.optics.sigma_a;
    const float finest = settings_.tsm.finest / std::max({extinction.x, extinction.y, extinction.z, 1e-6f});
    // four cells of the last level reach from any place to any other that matters
    const int all = std::countr_zero(unsigned(texels())) - 1;
    const auto level_of = [&](float width) { return std::log2(std::max(width / texel, 1e-6f)); };
    const int last = std::clamp(int(std::ceil(level_of(0.5f * drawn.object.reach))), 0, all);
    map.first_level = std::clamp(int(std::floor(level_of(finest))), 0, last);
    key.texel_m = std::exp2(0.125f * std::round(8.0f * std::log2(std::ldexp(texel, map.first_level))));
    key.levels = last - map.first_level + 1;
    if (map.kernel_table.name() != 0 && key == map.kernel_key) return;
    map.kernel_key = key;
    map.kernels = make_level_kernels(key);
    map.kernel_table =
        gpu::Texture({.format = gpu::Format::rgba32f, .width = LevelKernels::kColumns, .height = key.levels},
                     "translucency.tsm.kernels");
    map.kernel_table.upload(0, 0, map.kernels.table.data());
}

void TsmPass::gather(PassContext& context, const Drawn& drawn, size_t light, bool keeps) {
    Frame& frame = context.frame();
    const LightMap& map = drawn.object.maps[light];
    const gpu::Program& program = gather_programs_.use(frame, light, [&](const gpu::Program& fresh) {
        frame.seams.bind(Seam::light_transmittance, fresh, context);
        bind_pixels(fresh, context, drawn.seen, drawn.object.interior);
    });
    map.view_block.bind(program);
    program.set("light_index", unsigned(light));
    program.set("keeps", keeps ? 1.0f : 0.0f);
    program.set("gathers", map.view.whole ? 1.0f : 0.0f);
    if (map.view.whole) {
        const float width = map.kernels.first_width;
        program.image("light_map", map.light, 0, false);
        program.image("light_spread", map.spread, 0, false);
        program.image("kernels", map.kernel_table, 0, false);
        program.set("map_size", texels());
        program.set("levels", glm::ivec2(map.first_level, map.first_level + map.kernel_key.levels - 1));
        program.set("first", glm::vec4(map.kernels.first_height, 1.0f / (width * width)));
        program.set("own_share", glm::vec4(map.kernels.own_share, 1.0f / map.kernel_key.farthest_m));
    }
    dispatch_pixels(drawn.seen.pixels.size);
}

}  // namespace tyndall::translucency
