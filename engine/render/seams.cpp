#include "render/seams.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/error.h"

namespace tyndall {
namespace {

constexpr size_t kSeams = 5;
constexpr std::array<std::string_view, kSeams> kNames{"shading_model", "light_transmittance", "indirect_light",
                                                      "media_segment", "sky"};

struct Provider {
    SeamProvider provider;
    uint32_t number = 0;  ///< of a shading model; stays the same while other models come and go
};
using Providers = std::vector<Provider>;

/// Which models a program has: all of them, or those that it defines (Seams::shading_models).
std::string define_of(const Provider& model) {
    return fmt::format("SHADING_MODEL_{}", model.number);
}

std::string model_case(const Provider& model, std::string_view call) {
    return fmt::format("#if !defined({}) || defined({})\n        case {}u: return {};\n#endif\n", kStandardModelOnly,
                       define_of(model), model.number, call);
}

std::string shading_model_text(const Providers& providers) {
    std::string receivers =
        "LightReceiver light_receiver(uint model, ShadingPoint s, vec3 to_light) {\n    switch (model) {\n";
    std::string models = "LightTerms shade(uint model, ShadingPoint s, LightSample l) {\n    switch (model) {\n";
    for (const Provider& model : providers) {
        if (model.number == 0) continue;
        models += model_case(model, model.provider.function + "(s, l)");
        if (!model.provider.receiver.empty()) receivers += model_case(model, model.provider.receiver + "(s, to_light)");
    }
    return receivers + "        default: return LightReceiver(s.position, s.normal);\n    }\n}\n" + models +
           fmt::format("        default: return {}(s, l);\n    }}\n}}\n", providers.front().provider.function);
}

std::string light_transmittance_text(const Providers& providers) {
    std::string text = "vec3 light_transmittance(uint light, vec3 p, vec3 n) {\n    vec3 transmittance = vec3(1.0);\n";
    for (const Provider& provider : providers)
        text += fmt::format("    transmittance *= {}(light, p, n);\n", provider.provider.function);
    return text + "    return transmittance;\n}\n";
}

std::string indirect_light_text(const Providers& providers) {
    std::string text =
        "IndirectLight indirect_light(vec3 p, vec3 n, vec3 v, float roughness) {\n"
        "    IndirectLight sum = IndirectLight(vec3(0.0), vec3(0.0));\n    IndirectLight one;\n";
    for (const Provider& provider : providers)
        text += fmt::format(
            "    one = {}(p, n, v, roughness);\n    sum.irradiance += one.irradiance;\n    sum.specular += "
            "one.specular;\n",
            provider.provider.function);
    return text + "    return sum;\n}\n";
}

// One solver after the other, as if the first one's medium stood before the next one's: exact for one solver, which is
// what a frame should have.
std::string media_segment_text(const Providers& providers) {
    std::string text =
        "MediaSegment media_segment(vec2 uv, vec3 p) {\n"
        "    MediaSegment all = MediaSegment(vec3(0.0), vec3(1.0));\n    MediaSegment one;\n";
    for (const Provider& provider : providers)
        text += fmt::format(
            "    one = {}(uv, p);\n    all.in_scatter += all.transmittance * one.in_scatter;\n"
            "    all.transmittance *= one.transmittance;\n",
            provider.provider.function);
    return text + "    return all;\n}\n";
}

std::string sky_text(const Providers& providers) {
    return fmt::format("vec3 sky_radiance(vec3 direction) {{\n    return {};\n}}\n",
                       providers.empty() ? "vec3(0.0)" : providers.back().provider.function + "(direction)");
}

std::string text_of(Seam seam, const Providers& providers) {
    std::string text =
        fmt::format("// The seam {}: made from its {} providers.\n#include \"render/shaders/seam_types.glsl\"\n",
                    kNames.at(static_cast<size_t>(seam)), providers.size());
    for (const Provider& provider : providers) text += fmt::format("#include \"{}\"\n", provider.provider.include);
    switch (seam) {
        case Seam::shading_model:
            return text + shading_model_text(providers);
        case Seam::light_transmittance:
            return text + light_transmittance_text(providers);
        case Seam::indirect_light:
            return text + indirect_light_text(providers);
        case Seam::media_segment:
            return text + media_segment_text(providers);
        case Seam::sky:
            return text + sky_text(providers);
    }
    return text;
}

}  // namespace

std::string_view name_of(Seam seam) {
    return kNames.at(static_cast<size_t>(seam));
}

struct Seams::Implementation {
    explicit Implementation(gpu::ShaderLibrary& library) : shaders(library) {}

    Providers& of(Seam seam) { return providers.at(static_cast<size_t>(seam)); }
    void changed(Seam seam) {
        shaders.set_text(fmt::format("seams/{}.glsl", kNames.at(static_cast<size_t>(seam))), text_of(seam, of(seam)));
        ++version;
    }
    uint32_t free_number(Seam seam) {
        uint32_t number = 0;
        while (std::ranges::find(of(seam), number, &Provider::number) != of(seam).end()) ++number;
        return number;
    }

    gpu::ShaderLibrary& shaders;
    std::array<Providers, kSeams> providers;
    uint64_t version = 0;
};

Seams::Seams(gpu::ShaderLibrary& shaders) : self_(std::make_unique<Implementation>(shaders)) {
    self_->of(Seam::shading_model)
        .push_back({{"standard", "render/shaders/standard_model.glsl", "standard_shading_model", {}, {}}, 0});
    for (size_t i = 0; i < kSeams; ++i) self_->changed(static_cast<Seam>(i));
}

Seams::~Seams() = default;

void Seams::add(Seam seam, SeamProvider provider) {
    Providers& known = self_->of(seam);
    for (const Provider& other : known)
        if (other.provider.name == provider.name)
            throw Error(fmt::format("seam {} has a provider '{}' already", kNames.at(static_cast<size_t>(seam)),
                                    provider.name));
    const uint32_t number = self_->free_number(seam);
    known.push_back({std::move(provider), number});
    self_->changed(seam);
}

void Seams::remove(Seam seam, const std::string& name) {
    Providers& known = self_->of(seam);
    const bool kept = seam == Seam::shading_model && name == "standard";
    const auto gone = [&](const Provider& provider) { return !kept && provider.provider.name == name; };
    if (std::erase_if(known, gone) > 0) self_->changed(seam);
}

std::vector<std::string> Seams::providers(Seam seam) const {
    std::vector<std::string> names;
    for (const Provider& provider : self_->of(seam)) names.push_back(provider.provider.name);
    return names;
}

uint32_t Seams::shading_model(const std::string& name) const {
    for (const Provider& provider : self_->of(Seam::shading_model))
        if (provider.provider.name == name) return provider.number;
    return 0;
}

ShadingModelUse Seams::shading_models(PassContext& context) const {
    ShadingModelUse all{{kStandardModelOnly}, {}};
    for (const Provider& model : self_->of(Seam::shading_model)) {
        if (model.number == 0) continue;
        ShadingModelUse one{{}, {glm::ivec2(0), context.size()}};
        if (model.provider.use) one = model.provider.use(context);
        if (one.pixels.empty()) continue;
        all.defines.push_back(define_of(model));
        all.defines.insert(all.defines.end(), one.defines.begin(), one.defines.end());
        all.pixels = united(all.pixels, one.pixels);
    }
    return all;
}

void Seams::declare(Seam seam, PassDeclaration& declaration) const {
    for (const Provider& provider : self_->of(seam))
        for (const std::string& target : provider.provider.reads)
            declaration.reads(target,
                              fmt::format("{} by {}", kNames.at(static_cast<size_t>(seam)), provider.provider.name));
}

void Seams::bind(Seam seam, const gpu::Program& program, PassContext& context) const {
    for (const Provider& provider : self_->of(seam))
        if (provider.provider.bind) provider.provider.bind(program, context);
}

uint64_t Seams::version() const {
    return self_->version;
}

}  // namespace tyndall
