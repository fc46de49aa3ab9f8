#include "texture_space/texture_space_pass.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/gtc/matrix_inverse.hpp>

#include "render/frame.h"
#include "render/frustum.h"
#include "render/gpu_scene.h"
#include "render/light_state.h"
#include "render/pixel_rectangle.h"
#include "seen_mesh.h"
#include "seen_rectangle.h"
#include "texture_space/hable_taps.h"

namespace tyndall::skin {
namespace {

void bind_texels(const gpu::Program& program, const Surface& surface, const SurfaceMaps& maps) {
    program.image("map", maps.light(), 0, true);
    bind_list(program, "places", maps.atlas().places);
    bind_list(program, "normals", maps.atlas().normals);
    bind_list(program, "finish", maps.finish.list());
    bind_list(program, "occlusion", maps.finish.occlusion());
    program.set("world_from_local", surface.transform);
    program.set("normal_from_local", glm::inverseTranspose(glm::mat3(surface.transform)));
}

/// Texels that may be seen.
ChunkSet seen_chunks(PassContext& context, const Surface& surface, const AtlasChunks& chunks) {
    const glm::mat4 local_from_world = glm::inverse(surface.transform);
    const FrameBlock& block = context.frame().block;
    ChunkSet set = surface.material->double_sided
                       ? chunks.all()
                       : chunks.seen_from(local_from_world * glm::vec4(glm::vec3(block.eye_near), 1.0f));
    const Frustum frustum(block.view_projection);
    const glm::mat3 linear(surface.transform);
    const float longest = std::max({glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2])});
    chunks.remove(set, [&](const glm::vec3& centre, float radius) {
        const glm::vec3 middle(surface.transform * glm::vec4(centre, 1.0f));
        return frustum.touches({middle - longest * radius, middle + longest * radius});
    });
    return set;
}

/// Metres of the world from which light comes.
float reach_of(const physics::DiffusionProfile& profile, MapTechnique technique) {
    if (technique == MapTechnique::taps) {
        float reach = 0.0f;
        for (const HableTap& tap : hable_taps(profile)) reach = std::max(reach, glm::length(tap.offset));
        return reach;
    }
    constexpr float kDeviations = 3.5f;
    return profile.lobes.empty() ? 0.0f : kDeviations * std::sqrt(profile.lobes.back().variance_m2);
}

/// Those and the ones that their light comes from.
ChunkSet lit_chunks(const Surface& surface, const ChunkSet& seen, MapTechnique technique, AtlasChunks& chunks) {
    const glm::mat3 linear(surface.transform);
    const float shortest = std::min({glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2])});
    return chunks.grown(seen, reach_of(surface.diffusion->profile, technique) / std::max(shortest, 1e-12f));
}

/// Where a light stands, or with w = 0 the direction to it, in the mesh's space.
glm::vec4 place_of(const Light& light, const glm::mat4& local_from_world) {
    if (light.kind == LightKind::directional) return local_from_world * glm::vec4(glm::vec3(light.transform[2]), 0.0f);
    return local_from_world * glm::vec4(glm::vec3(light.transform[3]), 1.0f);
}

}  // namespace

TextureSpacePass::TextureSpacePass(std::shared_ptr<SkinTables> tables, const SkinSettings& settings)
    : tables_(std::move(tables)),
      settings_(settings),
      light_programs_(
          {.name = "skin.texture_space.light", .compute = "skin/texture_space/light.comp", .defines = {"CHUNKS"}}),
      first_light_programs_({.name = "skin.texture_space.first_light",
                             .compute = "skin/texture_space/light.comp",
                             .defines = {"CHUNKS", "BEGINS"}}) {}

void TextureSpacePass::declare(PassDeclaration& declaration) {
    declaration.stage(Stage::diffusion)
        .reads("scene_depth", "where the surfaces are seen")
        .reads("gbuffer_surface", "which surface is seen")
        .updates("light_diffuse", "irradiance spread under the skin, in place of what arrives there")
        .after("skin.screen");
}

void TextureSpacePass::execute(PassContext& context) {
    const RenderScene& scene = context.frame().scene;
    if (settings_.enabled) {
        for (const size_t index : surfaces_of(scene, Technique::six_gaussians))
            render(context, index, MapTechnique::lobes);
        for (const size_t index : surfaces_of(scene, Technique::hable)) render(context, index, MapTechnique::taps);
    }
    maps_.end_frame();
}

void TextureSpacePass::render(PassContext& context, size_t index, MapTechnique technique) {
    Frame& frame = context.frame();
    const Surface& surface = frame.scene.surfaces[index];
    if (!has_volume(surface) || pixels_of(surface.bounds, frame.block.view_projection, context.size()).empty()) return;
    if (!usable_.usable(*surface.mesh, surface.material->name)) return;
    const Stretch stretch = stretch_of(surface.transform);
    const Drawn drawn{surface,
                      index,
                      technique,
                      stretch,
                      surface.diffusion->profile.scaled(1.0f / stretch.scale),
                      usable_pre_scatter(*surface.material, surface.diffusion->pre_scatter),
                      maps_of(context, surface, technique, stretch)};
    std::string state = state_of(context, drawn);
    const bool same = settings_.texture_space.keep && state == drawn.maps.made_from;
    ChunkSet seen = seen_chunks(context, surface, drawn.maps.chunks());
    if (!same || !holds(drawn.maps.made, seen)) {
        // where only the camera moves all of it is made once
        if (same) seen = drawn.maps.chunks().all();
        make(context, drawn, seen);
        drawn.maps.made_from = std::move(state);
        drawn.maps.made = std::move(seen);
    }
    draw(context, drawn);
}

void TextureSpacePass::make(PassContext& context, const Drawn& drawn, const ChunkSet& seen) {
    Frame& frame = context.frame();
    drawn.maps.finish.update(frame.shaders, frame.gpu_scene, *drawn.surface.material, drawn.pre_scatter,
                             drawn.maps.atlas(), drawn.maps.tile());
    const ChunkSet lit = lit_chunks(drawn.surface, seen, drawn.technique, drawn.maps.chunks());
    drawn.maps.choose(drawn.technique == MapTechnique::taps ? seen : lit);
    light(context, drawn, lit);
    drawn.maps.spread(frame.shaders, drawn.profile);
}

/// As fine as settings say, or as pixels are.
SurfaceMaps& TextureSpacePass::maps_of(PassContext& context, const Surface& surface, MapTechnique technique,
                                       const Stretch& stretch) {
    const auto at = [&](int size) -> SurfaceMaps& {
        const MapKey key{surface.mesh->id, size, technique, stretch.key};
        std::unique_ptr<SurfaceMaps>& maps = maps_.at(key);
        if (!maps) maps = std::make_unique<SurfaceMaps>(surface.mesh->mesh, key, stretch.shape);
        return *maps;
    };
    const int size = int(std::bit_floor(unsigned(settings_.texture_space.size)));
    SurfaceMaps& finest = at(size);
    const float texel_m = std::max(finest.texel_m() * stretch.scale, 1e-12f);
    // taps that go beyond the gutters would show seams
    const float reach = technique == MapTechnique::taps ? reach_of(surface.diffusion->profile, technique) : 0.0f;
    const float wanted_m =
        std::max(nearest_pixel_m(surface.bounds, context.frame()), 2.0f * reach / float(kGutterTexels));
    const int coarser = std::clamp(int(std::floor(std::log2(std::max(wanted_m / texel_m, 1e-6f)))), 0, 3);
    return coarser == 0 ? finest : at(std::max(size >> coarser, 32));
}

/// Equal while the map would show the same.
std::string TextureSpacePass::state_of(PassContext& context, const Drawn& drawn) const {
    const Frame& frame = context.frame();
    std::string state;
    append_state(state, drawn.surface.transform);
    append_state(state, drawn.surface.material->id);
    append_state(state, drawn.pre_scatter);
    for (const physics::DiffusionLobe& lobe : drawn.profile.lobes) append_state(state, lobe);
    append_state(state, drawn.surface.diffusion->corrections);
    for (size_t i = 0; i < frame.scene.lights.size(); ++i) append_light_state(state, frame, i, maps_.frame());
    append_surroundings_state(state, frame, maps_.frame());
    // how sharp slides are drawn goes by their size in the picture
    const auto has_gobo = [](const Light& light) { return light.gobo != nullptr; };
    if (std::ranges::any_of(frame.scene.lights, has_gobo)) append_state(state, frame.block.eye_near);
    return state;
}

/// Fills the map with what enters. Where nothing comes from all around the first light begins it, as far as it reaches.
void TextureSpacePass::light(PassContext& context, const Drawn& drawn, const ChunkSet& set) {
    Frame& frame = context.frame();
    const std::vector<Light>& lights = frame.scene.lights;
    const glm::mat4 local_from_world = glm::inverse(drawn.surface.transform);
    const auto lit_by = [&](size_t light) {
        return set & drawn.maps.chunks().lit_from(place_of(lights[light], local_from_world));
    };
    const bool dark = !has_light_all_around(frame.scene) && frame.seams.providers(Seam::indirect_light).size() <= 1;
    const bool light_begins = dark && !lights.empty();
    begin(context, drawn, light_begins ? without(set, lit_by(0)) : set, dark);
    first_light_programs_.begin();
    light_programs_.begin();
    for (size_t i = 0; i < lights.size(); ++i) {
        LightPrograms& programs = i == 0 && light_begins ? first_light_programs_ : light_programs_;
        const gpu::Program& program = programs.use(frame, i, [&](const gpu::Program& fresh) {
            frame.seams.bind(Seam::light_transmittance, fresh, context);
            tables_->bind(fresh, frame.scene);
            bind_texels(fresh, drawn.surface, drawn.maps);
            fresh.set("layers", tables_->layers(drawn.index));
        });
        program.set("light_index", unsigned(i));
        list_.update(drawn.maps.atlas(), lit_by(i), false);
        list_.dispatch(program);
    }
}

/// With light from all around, or nothing.
void TextureSpacePass::begin(PassContext& context, const Drawn& drawn, const ChunkSet& set, bool dark) {
    Frame& frame = context.frame();
    gpu::ProgramDesc desc{
        .name = "skin.texture_space.enter", .compute = "skin/texture_space/enter.comp", .defines = {"CHUNKS"}};
    if (dark) desc.defines.emplace_back("DARK");
    const gpu::Program& program = frame.shaders.program(desc);
    program.use();
    bind_frame(program, frame);
    frame.seams.bind(Seam::indirect_light, program, context);
    bind_texels(program, drawn.surface, drawn.maps);
    list_.update(drawn.maps.atlas(), set, false);
    list_.dispatch(program);
}

/// The mesh once more, where it is what is seen.
void TextureSpacePass::draw(PassContext& context, const Drawn& drawn) {
    static constexpr std::string_view kTargets[] = {"light_diffuse", "scene_depth"};
    Frame& frame = context.frame();
    const Material& material = *drawn.surface.material;
    const glm::vec3& limb = drawn.surface.diffusion->corrections.limb;
    const bool coloured = drawn.pre_scatter > 0.0f;
    gpu::ProgramDesc desc{.name = "skin.texture_space.surface",
                          .vertex = "skin/surface.vert",
                          .fragment = "skin/texture_space/surface.frag"};
    if (coloured) desc.defines.emplace_back("COLOURED");
    if (drawn.pre_scatter == 0.5f) desc.defines.emplace_back("ROOT");
    if (limb != glm::vec3(0.0f)) desc.defines.emplace_back("LIMB");
    context.bind_targets(kTargets, -1);
    const gpu::Program& program = frame.shaders.program(desc);
    program.use();
    bind_frame(program, frame);
    program.texture("gbuffer_surface", context.texture("gbuffer_surface"), {.filter = gpu::Filter::nearest});
    program.texture("map", drawn.maps.result(), {.filter = gpu::Filter::linear});
    program.set("map_from_uv", drawn.maps.map_from_uv());
    program.set("limb", limb);
    if (coloured) {
        program.set("base_colour", glm::vec3(material.base_colour));
        program.set("pre_scatter", drawn.pre_scatter);
        bind_slot(program, frame.gpu_scene, "base_colour_map", material.base_colour_texture);
    }
    draw_seen_mesh(program, drawn.surface, frame);
}

}  // namespace tyndall::skin
