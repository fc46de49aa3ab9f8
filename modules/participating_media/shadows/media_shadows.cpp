#include "shadows/media_shadows.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "render/frame.h"

namespace tyndall::participating_media {
namespace {

constexpr size_t kMappedLights = 64;  ///< as in shaders/shadows/read.glsl

/// MediaShadow of shaders/shadows/read.glsl.
struct GpuShadow {
    glm::mat4 map_from_world{1.0f};
    glm::vec4 origin_kind{0.0f};
    glm::vec4 depths{0.0f};
    glm::ivec4 turns{0};
};
static_assert(sizeof(GpuShadow) == 112);

void add_volume(std::string& key, const std::shared_ptr<const VolumeAsset>& volume) {
    key += fmt::format(" {}", volume ? volume->id : 0);
}

/// The files that the density is read from: a sequence's next file lies where the last one lay.
void add_volumes(std::string& key, const DensityField& density) {
    if (const auto* grid = std::get_if<GridDensity>(&density)) add_volume(key, grid->volume);
    if (const auto* product = std::get_if<ProductDensity>(&density)) {
        add_volumes(key, *product->base);
        if (product->mask) add_volume(key, product->mask->volume);
    }
}

}  // namespace

struct MediaShadows::Block {
    std::array<GpuShadow, kMappedLights> lights;
};

void MediaShadows::update_version(const MediaBuffer& media) {
    std::string key = media.bytes();
    for (const Medium& medium : media.media()) add_volumes(key, medium.density);
    if (key == media_key_ && media_version_ != 0) return;
    media_key_ = std::move(key);
    ++media_version_;
}

void MediaShadows::plan(Block& block, const RenderScene& scene, const UnevenMedia& uneven,
                        const MediaSettings& settings) {
    const MediaShadowSettings& shadows = settings.shadows;
    const bool maps = shadows.method != ShadowMethod::march && shadows.method != ShadowMethod::clipmap;
    const bool fourier = shadows.method == ShadowMethod::fourier_map;
    layers_ = fourier ? 1 + shadows.terms : shadows.layers;
    for (size_t i = 0; i < std::min(scene.lights.size(), kMappedLights); ++i) {
        if (scene.lights[i].intensity == glm::vec3(0.0f)) continue;
        GpuShadow& record = block.lights[i];
        const std::optional<ShadowFit> fit = fit_shadow_map(scene.lights[i], uneven, shadows.size);
        if (!fit) continue;  // it meets none of them
        if (maps && wanted_.size() < static_cast<size_t>(shadows.maps)) {
            record.map_from_world = fit->map_from_world;
            record.origin_kind = glm::vec4(fit->origin, static_cast<float>(fit->kind));
            record.depths = {fit->near_m, 1.0f / (fit->far_m - fit->near_m), static_cast<float>(layers_ - 1),
                             static_cast<float>(static_cast<int>(wanted_.size()) * layers_) + 0.5f};
            record.turns = {fourier ? 0 : 1, fourier ? shadows.terms : 0, 0, 0};
            (fourier ? kinds_.fourier : kinds_.opacity) = true;
            wanted_.push_back({*fit, media_version_, shadows});
        } else if (shadows.method == ShadowMethod::march) {
            record.turns.w = settings.light_steps;
            kinds_.marched = true;
        } else {
            record.turns.z = 1;
            kinds_.clipmap = true;
        }
    }
}

void MediaShadows::make_textures() {
    if (nothing_.name() == 0) {  // programs want something bound
        nothing_ = gpu::Texture({.shape = gpu::Shape::volume, .format = gpu::Format::rgba16f},
                                "participating_media.no_shadow");
        nothing_.clear(0, glm::vec4(0.0f));
        buffer_ = gpu::Buffer(sizeof(Block), nullptr, "media shadows");
        uploaded_.clear();
    }
    if (wanted_.empty()) {
        maps_ = gpu::Texture();
        return;
    }
    const gpu::TextureDesc desc{.shape = gpu::Shape::volume,
                                .format = gpu::Format::rgba16f,
                                .width = wanted_.front().settings.size,
                                .height = wanted_.front().settings.size,
                                .layers = static_cast<int>(wanted_.size()) * layers_};
    if (maps_.name() != 0 && maps_.desc() == desc) return;
    maps_ = gpu::Texture(desc, "participating_media.shadow_maps");
    made_maps_.clear();
}

void MediaShadows::update(Frame& frame, const MediaBuffer& media, const MediaSettings& settings) {
    const UnevenMedia uneven = uneven_media(media.media(), frame.scene);
    made_ = 0;
    kinds_ = {.marched = !uneven.empty() && frame.scene.lights.size() > kMappedLights,
              .surface_glow = settings.analytic.surface_glow && media.plan().uses(Solver::analytic)};
    wanted_.clear();
    Block block;
    if (!uneven.empty()) {
        update_version(media);
        plan(block, frame.scene, uneven, settings);
    }
    frame.shaders.set_text("participating_media/media_kinds.glsl", media_kinds(media.media(), kinds_));
    make_textures();
    make_maps(frame.shaders, media);
    if (kinds_.clipmap) {
        clipmap_.update(frame.shaders, media, uneven.bounds, glm::vec3(frame.scene.camera.transform[3]),
                        settings.shadows, media_version_);
        made_ += clipmap_.filled();
    } else {
        clipmap_.forget();
    }
    upload(block);
}

void MediaShadows::make_maps(gpu::ShaderLibrary& shaders, const MediaBuffer& media) {
    const gpu::Program* program = nullptr;
    made_maps_.resize(wanted_.size());
    for (size_t i = 0; i < wanted_.size(); ++i) {
        if (made_maps_[i] == wanted_[i]) continue;
        if (program == nullptr) {
            gpu::ProgramDesc desc{.name = "participating_media.shadows.map",
                                  .compute = "participating_media/shadows/map.comp"};
            if (kinds_.fourier) desc.defines = {fmt::format("TERMS {}", wanted_[i].settings.terms)};
            program = &shaders.program(desc);
            program->use();
            media.bind(*program, 1);
        }
        make_map(*program, i);
        made_maps_[i] = wanted_[i];
        ++made_;
    }
    if (program != nullptr) glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void MediaShadows::make_map(const gpu::Program& program, size_t map) const {
    const ShadowFit& fit = wanted_[map].fit;
    const MediaShadowSettings& settings = wanted_[map].settings;
    program.image("shadow_map", maps_, 0, true);
    program.set("map_kind", static_cast<int>(fit.kind));
    program.set("map_origin", fit.origin);
    program.set("map_base", fit.base);
    program.set("map_across", fit.across);
    program.set("map_up", fit.up);
    program.set("map_range", glm::vec2(fit.near_m, fit.far_m));
    program.set("map_size", settings.size);
    program.set("first_layer", static_cast<int>(map) * layers_);
    program.set("map_planes", settings.layers);
    program.set("map_samples", settings.samples);
    const auto groups = static_cast<GLuint>((settings.size + 7) / 8);
    glDispatchCompute(groups, groups, 1);
}

void MediaShadows::upload(const Block& block) {
    std::string bytes(reinterpret_cast<const char*>(&block), sizeof(Block));
    if (bytes == uploaded_) return;
    uploaded_ = std::move(bytes);
    buffer_.update(0, sizeof(Block), &block);
}

void MediaShadows::bind(const gpu::Program& program, const MediaSettings& settings) {
    make_textures();
    program.block("MediaShadows", buffer_);
    program.texture("media_shadow_maps", maps_.name() != 0 ? maps_ : nothing_, {.filter = gpu::Filter::linear});
    program.set("media_shadows_others", settings.light_steps);
    if (kinds_.clipmap)
        clipmap_.bind(program, settings.shadows);
    else
        program.texture("media_clipmap", nothing_);
}

void MediaShadowsPass::declare(PassDeclaration& declaration) {
    const TargetDesc desc{
        .format = gpu::Format::rgba16f, .shape = gpu::Shape::volume, .own = [this] { return shadows_->maps(); }};
    declaration.stage(Stage::light_space)
        .writes("media_shadows", desc, "optical depth of media seen from each light, kept while nothing changes");
}

void MediaShadowsPass::execute(PassContext& context) {
    shadows_->update(context.frame(), *media_, settings_);
}

}  // namespace tyndall::participating_media
