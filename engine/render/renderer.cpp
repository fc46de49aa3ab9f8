#include "render/renderer.h"

#include <algorithm>

#include "core/error.h"
#include "core/log.h"
#include "render/compose_passes.h"
#include "render/display_passes.h"
#include "render/frame.h"
#include "render/frame_block.h"
#include "render/geometry_passes.h"
#include "render/gpu_scene.h"
#include "render/guarded_pass.h"
#include "render/image_settings.h"
#include "render/light_buffer.h"
#include "render/light_probes.h"
#include "render/lighting_passes.h"
#include "render/shadow_maps.h"

namespace tyndall {
namespace {

const std::vector<std::string> kPaths{"deferred", "light_pre_pass"};

void require(std::string_view name, const std::vector<std::string>& names, const std::string& what) {
    if (std::ranges::find(names, name) != names.end()) return;
    throw Error(Diagnostic{{}, what + " '" + std::string(name) + "' does not exist", {}, nearest_name(name, names)});
}

}  // namespace

struct Renderer::Implementation {
    Implementation(const ColorConfig& color, Settings& the_settings)
        : settings(the_settings), seams(shaders), gpu_scene(shaders), probes(shaders), transform(color, shaders) {
        settings.add<ImageSettings>();
        probes.provide(seams);
        seams.add(Seam::light_transmittance, shadow_map_provider());
    }

    Settings& settings;
    gpu::ShaderLibrary shaders;
    Seams seams;
    GpuScene gpu_scene;
    LightProbes probes;
    ShadowMaps shadow_maps;
    LightBuffer light_buffer;
    DisplayTransform transform;
    SpecularTableTexture table;
    FrameBlockBuffer block;

    ShadowPass shadows;
    GBufferPass gbuffer;
    ThinGBufferPass thin_gbuffer;
    IndirectPass indirect{seams, table};
    LightsPass lights{seams};
    ComposePass compose{table};
    MaterialPass materials{table};
    SkyPass sky{seams};
    MediaPass media{seams};
    DisplayPass display{transform};
    AntialiasPass antialias;
    ViewPass view{transform};

    std::vector<Pass*> module_passes;
    std::vector<std::unique_ptr<GuardedPass>> guarded;
    FrameGraph graph;
    std::string path = kPaths.front();
    std::string shown;  ///< target in place of the picture
    std::vector<std::string> retained;
    bool dirty = true;
    uint64_t seams_version = 0;
    uint64_t settings_fingerprint = 0;
    bool antialiased = false;
    std::string graph_problem;
    std::string frame_problem;
    glm::ivec2 size{16, 16};

    [[nodiscard]] std::vector<Pass*> engine_passes();
    void rebuild();
    bool build(std::vector<Pass*> passes);
    void refresh();
    void draw(const RenderScene& scene);
};

/// In the order of the frame; the graph orders by data and stage.
std::vector<Pass*> Renderer::Implementation::engine_passes() {
    const bool deferred = path == "deferred";
    std::vector<Pass*> passes{&shadows};
    passes.push_back(deferred ? static_cast<Pass*>(&gbuffer) : &thin_gbuffer);
    passes.insert(passes.end(), {&indirect, &lights});
    passes.push_back(deferred ? static_cast<Pass*>(&compose) : &materials);
    passes.push_back(&sky);
    if (!seams.providers(Seam::media_segment).empty()) passes.push_back(&media);
    if (!shown.empty()) {
        passes.push_back(&view);
    } else {
        passes.push_back(&display);
        if (antialiased) passes.push_back(&antialias);
    }
    return passes;
}

bool Renderer::Implementation::build(std::vector<Pass*> passes) {
    guarded.clear();
    std::vector<Pass*> wrapped;
    for (Pass* pass : passes) {
        guarded.push_back(std::make_unique<GuardedPass>(*pass));
        wrapped.push_back(guarded.back().get());
    }
    try {
        graph.set_passes(std::move(wrapped));
        graph.build(size);
        return true;
    } catch (const Error& error) {
        graph_problem = error.what();
        log::error("{}", error.what());
        return false;
    }
}

void Renderer::Implementation::rebuild() {
    dirty = false;
    seams_version = seams.version();
    display.set_antialiased(antialiased);
    view.set_target(shown);
    std::vector<std::string> kept = retained;
    kept.insert(kept.end(), {"radiance", "display"});
    if (!shown.empty()) kept.push_back(shown);
    graph.retain(std::move(kept));
    graph_problem.clear();
    std::vector<Pass*> passes = engine_passes();
    passes.insert(passes.end(), module_passes.begin(), module_passes.end());
    if (build(std::move(passes))) return;
    const std::string problem = graph_problem;  // a module's pass does not fit: go on without
    build(engine_passes());
    graph_problem = problem;
}

/// Rebuilds the graph when what it was made from has changed.
void Renderer::Implementation::refresh() {
    if (!dirty && seams_version == seams.version() && settings_fingerprint == settings.fingerprint()) return;
    settings_fingerprint = settings.fingerprint();
    antialiased = settings.get<ImageSettings>().antialiasing != Antialiasing::none;
    rebuild();
}

Renderer::Renderer(const ColorConfig& color, Settings& settings)
    : self_(std::make_unique<Implementation>(color, settings)) {}
Renderer::~Renderer() = default;

Seams& Renderer::seams() {
    return self_->seams;
}
gpu::ShaderLibrary& Renderer::shaders() {
    return self_->shaders;
}
FrameGraph& Renderer::graph() {
    return self_->graph;
}

void Renderer::add_pass(Pass* pass) {
    self_->module_passes.push_back(pass);
    self_->dirty = true;
}

void Renderer::remove_passes(std::span<Pass* const> passes) {
    const auto leaves = [&](Pass* pass) { return std::ranges::find(passes, pass) != passes.end(); };
    if (std::erase_if(self_->module_passes, leaves) == 0) return;
    self_->rebuild();  // at once: the graph must not hold on to a pass that is about to die
}

std::vector<std::string> Renderer::paths() {
    return kPaths;
}

void Renderer::set_path(std::string_view path) {
    require(path, kPaths, "render path");
    self_->path = path;
    self_->dirty = true;
}

std::string_view Renderer::path() const {
    return self_->path;
}

void Renderer::set_display(const std::string& display, const std::string& view) {
    self_->transform.set(display, view);
}

void Renderer::color_changed() {
    self_->transform.reload();
}

std::vector<std::string> Renderer::views() const {
    self_->refresh();
    std::vector<std::string> names = self_->graph.targets();
    std::erase_if(names, [](const std::string& name) { return name == "display" || name == "encoded"; });
    return names;
}

void Renderer::show(std::string_view target) {
    if (!target.empty()) require(target, views(), "target");
    self_->shown = target;
    self_->dirty = true;
}

const std::string& Renderer::shown() const {
    return self_->shown;
}

void Renderer::retain(std::vector<std::string> targets) {
    self_->retained = std::move(targets);
    self_->dirty = true;
}

void Renderer::render(const RenderScene& scene, glm::ivec2 size) {
    Implementation& self = *self_;
    self.size = glm::max(size, glm::ivec2(1));
    self.refresh();
    try {
        self.draw(scene);
        self.frame_problem.clear();
    } catch (const Error& error) {  // an asset that the driver cannot take
        if (self.frame_problem != error.what()) log::error("{}", error.what());
        self.frame_problem = error.what();
    }
}

void Renderer::Implementation::draw(const RenderScene& scene) {
    gpu_scene.update(scene, seams);
    probes.update(scene);
    block.update(scene, size);
    const FrameBlock& values = block.block();
    shadow_maps.prepare(scene, gpu_scene.bounds(), glm::vec2(values.tan_half_fov_exposure));
    light_buffer.update(scene, shadow_maps, gpu_scene, shaders);
    Frame frame{scene, shaders, seams, gpu_scene, shadow_maps, settings, values, block.buffer(), light_buffer};
    graph.execute(frame, size, scene.camera_cut);
}

const gpu::Texture* Renderer::target(std::string_view name) const {
    return self_->graph.target(name);
}

int Renderer::reload_changed() {
    return self_->shaders.reload_changed();
}

std::string Renderer::problems() const {
    std::string text = self_->shaders.broken();
    for (const std::string& problem : {self_->graph_problem, self_->frame_problem}) {
        if (!problem.empty()) text += (text.empty() ? "" : "\n") + problem;
    }
    for (const auto& pass : self_->guarded)
        if (!pass->problem().empty()) text += (text.empty() ? "" : "\n") + pass->problem();
    return text;
}

void Renderer::set_timing(bool on) {
    self_->graph.set_timing(on);
}

FrameStatistics Renderer::statistics() const {
    return {self_->graph.times(), self_->gpu_scene.triangles_drawn(), self_->graph.memory(),
            self_->shadow_maps.rendered()};
}

}  // namespace tyndall
