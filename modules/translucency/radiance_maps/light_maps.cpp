#include "radiance_maps/light_maps.h"

#include <epoxy/gl.h>

#include <array>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "render/draw_state.h"

namespace tyndall::translucency {
namespace {

/// Light nearer than this many radii of the object sees it through the faces of a cube.
constexpr float kNear = 1.25f;

/// The block "Layers" of shaders/radiance_maps/layers.glsl.
struct LayersBlock {
    struct Layer {
        glm::mat4 clip_from_body{1.0f};
        glm::vec4 eye{0.0f};   ///< w 1 in perspective
        glm::vec4 axis{0.0f};  ///< w the map's side
    };
    std::array<Layer, LightMaps::kMaxLayers> layers;
};

bool nearly_the_same(const LightMaps::Layer& a, const LightMaps::Layer& b, float radius) {
    return a.light == b.light && a.view.perspective == b.view.perspective &&
           glm::distance(a.view.axis, b.view.axis) < 1e-4f && glm::distance(a.view.eye, b.view.eye) < 1e-4f * radius &&
           std::abs(a.view.side - b.view.side) < 1e-3f * b.view.side;
}

/// Of one light.
std::vector<MapView> views_of(const Light& light, const glm::mat4& body_from_world, const ViewMaps& body,
                              int resolution) {
    if (light.kind == LightKind::directional) {
        const glm::vec3 travel = glm::mat3(body_from_world) * -glm::vec3(light.transform[2]);
        return {parallel_view(body.drawn().positions, glm::normalize(travel), resolution)};
    }
    const glm::vec3 eye(body_from_world * light.transform[3]);
    if (glm::distance(eye, body.middle) > kNear * body.radius) return {perspective_view(eye, body.middle, body.radius)};
    std::vector<MapView> faces;
    for (int face = 0; face < 6; ++face) faces.push_back(cube_view(eye, face, body.radius));
    return faces;
}

gpu::TextureDesc array_desc(gpu::Format format, int resolution, size_t layers) {
    return {
        .shape = gpu::Shape::array, .format = format, .width = resolution, .height = resolution, .layers = int(layers)};
}

}  // namespace

bool LightMaps::fit(const RenderScene& scene, const glm::mat4& world_from_body, const ViewMaps& body, int resolution) {
    const glm::mat4 body_from_world = glm::inverse(world_from_body);
    std::vector<Layer> wanted;
    left_out_ = 0;
    for (size_t i = 0; i < scene.lights.size(); ++i) {
        if (scene.lights[i].intensity == glm::vec3(0.0f)) continue;
        const std::vector<MapView> views = views_of(scene.lights[i], body_from_world, body, resolution);
        if (wanted.size() + views.size() > size_t(kMaxLayers))
            ++left_out_;
        else
            for (const MapView& view : views) wanted.push_back({view, i});
    }
    bool same = resolution == resolution_ && wanted.size() == layers_.size();
    for (size_t i = 0; same && i < wanted.size(); ++i) same = nearly_the_same(wanted[i], layers_[i], body.radius);
    if (same) return false;
    const bool room = resolution == resolution_ && wanted.size() == layers_.size();
    layers_ = std::move(wanted);
    resolution_ = resolution;
    if (!room) make_textures();
    make_block();
    return true;
}

void LightMaps::make_textures() {
    targets_.clear();
    if (layers_.empty()) return;
    const auto make = [&](gpu::Format format, const char* label) {
        gpu::Texture texture(array_desc(format, resolution_, layers_.size()), label);
        texture.clear(0, glm::vec4(0.0f));
        return texture;
    };
    seen_places_ = make(gpu::Format::rgba32f, "translucency.maps.seen_places");
    seen_scales_ = make(gpu::Format::rgba16f, "translucency.maps.seen_scales");
    entry_places_ = make(gpu::Format::rgba32f, "translucency.maps.entry_places");
    entry_fluxes_ = make(gpu::Format::rgba32f, "translucency.maps.entry_fluxes");
    entered_ = make(gpu::Format::r32f, "translucency.maps.entered");
    depth_ = gpu::Texture({.format = gpu::Format::depth32f, .width = resolution_, .height = resolution_},
                          "translucency.maps.light_depth");
    for (int i = 0; i < int(layers_.size()); ++i) {
        const std::array<gpu::Framebuffer::Attachment, 2> colours{
            {{.texture = &seen_places_, .layer = i}, {.texture = &seen_scales_, .layer = i}}};
        targets_.emplace_back(colours, gpu::Framebuffer::Attachment{.texture = &depth_}, "translucency.maps.light");
    }
}

void LightMaps::make_block() {
    LayersBlock block;
    for (size_t i = 0; i < layers_.size(); ++i) {
        const MapView& view = layers_[i].view;
        block.layers[i] = {view.clip_from_body, glm::vec4(view.eye, view.perspective ? 1.0f : 0.0f),
                           glm::vec4(view.axis, view.side)};
    }
    block_ = gpu::Buffer(sizeof block, &block, "translucency.maps.layers");
}

void LightMaps::draw(gpu::ShaderLibrary& shaders, const ViewMaps& body, const gpu::Buffer& scales) {
    const gpu::Program& program = shaders.program({.name = "translucency.radiance_maps.map",
                                                   .vertex = "translucency/radiance_maps/map.vert",
                                                   .fragment = "translucency/radiance_maps/map.frag",
                                                   .defines = {"PLACES", "SCALES"}});
    program.use();
    const DrawState state(DepthState::write);
    for (size_t i = 0; i < layers_.size(); ++i) {
        targets_[i].bind();
        targets_[i].clear_colour(0, glm::vec4(0.0f));
        targets_[i].clear_colour(1, glm::vec4(0.0f));
        targets_[i].clear_depth();
        program.set("clip_from_body", layers_[i].view.clip_from_body);
        body.mesh().draw(scales);
    }
}

void LightMaps::bind(const gpu::Program& program) const {
    program.block("Layers", block_);
    program.set("layer_count", int(layers_.size()));
    program.set("light_resolution", resolution_);
    if (layers_.empty()) return;
    for (const auto& [name, texture] : {std::pair<const char*, const gpu::Texture*>{"seen_places", &seen_places_},
                                        {"seen_scales", &seen_scales_},
                                        {"entry_places", &entry_places_},
                                        {"entry_fluxes", &entry_fluxes_},
                                        {"entered", &entered_}}) {
        program.texture(name, *texture, {.filter = gpu::Filter::nearest});  // a program has one of the two
        program.image(name, *texture, 0, true);
    }
}

size_t LightMaps::bytes() const {
    constexpr size_t kTexel = 3 * 16 + 8 + 4;
    const size_t texels = size_t(resolution_) * size_t(resolution_);
    return texels * (kTexel * layers_.size() + 4);
}

}  // namespace tyndall::translucency
