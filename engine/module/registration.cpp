#include "module/registration.h"

#include "render/renderer.h"

namespace tyndall {

Registration::~Registration() {
    if (host_.renderer) {
        for (const auto& [seam, provider] : seams_) host_.renderer->seams().remove(seam, provider.name);
        std::vector<Pass*> leaving;
        for (const auto& pass : passes_) leaving.push_back(pass.get());
        host_.renderer->remove_passes(leaving);
        host_.renderer->shaders().drop(owner_ + ".");
    }
    passes_.clear();  // they and the functions of seams may look at settings until they are gone
    seams_.clear();
    for (const std::string& name : settings_) host_.settings.remove(name);
    for (const std::string& name : components_) {
        const ComponentId id = host_.components.find(name);
        host_.extractors.remove(name);
        for (World* world : host_.worlds) world->drop_components(id);
        host_.components.remove(id);
    }
}

void Registration::pass(std::unique_ptr<Pass> pass) {
    if (!pass->name().starts_with(owner_ + "."))
        throw Error("pass '" + std::string(pass->name()) + "' does not start with '" + owner_ + ".'");
    if (host_.renderer) host_.renderer->add_pass(pass.get());
    passes_.push_back(std::move(pass));
}

void Registration::seam(Seam seam, SeamProvider provider) {
    if (host_.renderer) host_.renderer->seams().add(seam, provider);
    seams_.emplace_back(seam, std::move(provider));
}

void Registration::add_component(std::shared_ptr<const StructType> type, Extractor extractor) {
    const std::string name = type->name;
    host_.components.add(std::move(type), owner_);
    components_.push_back(name);
    host_.extractors.add(name, std::move(extractor));
}

const void* Registration::add_settings(std::shared_ptr<const StructType> type) {
    const std::string name = type->name;
    host_.settings.add(std::move(type), owner_);
    settings_.push_back(name);
    return std::as_const(host_.settings).find(name);
}

std::vector<std::string> Registration::passes() const {
    std::vector<std::string> names;
    for (const auto& pass : passes_) names.emplace_back(pass->name());
    return names;
}

std::vector<std::string> Registration::seams() const {
    std::vector<std::string> names;
    for (const auto& [seam, provider] : seams_) names.emplace_back(name_of(seam));
    return names;
}

}  // namespace tyndall
