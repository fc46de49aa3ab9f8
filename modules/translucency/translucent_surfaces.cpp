#include "translucent_surfaces.h"

#include <algorithm>

#include "core/error.h"
#include "core/log.h"
#include "scene/field_reader.h"

namespace tyndall::translucency {

const std::vector<std::string>& technique_names() {
    static const std::vector<std::string> kNames{"plain", "points",    "htsm", "radiance_maps",
                                                 "tsm",   "thickness", "wrap", "scatter_maps"};
    return kNames;
}

bool is_translucent(const Surface& surface) {
    return surface.mesh && surface.interior && surface.interior->sigma_s_per_m != glm::vec3(0.0f);
}

Technique TechniquePlan::technique_of(const Surface& surface) {
    const std::string& asked = surface.interior->technique;
    const std::vector<std::string>& names = technique_names();
    if (const auto found = std::ranges::find(names, asked); found != names.end())
        return static_cast<Technique>(found - names.begin());
    if (asked != "auto" && refused_.insert(asked).second)
        log::warning("{}", Diagnostic{{},
                                      "interior/technique: '" + asked + "' does not exist",
                                      "auto or one of " + join_names(names),
                                      nearest_name(asked, names)}
                               .text());
    const bool even = std::holds_alternative<ConstantDensity>(surface.interior->density);
    const Technique technique = even ? Technique::points : Technique::htsm;
    log_choice(surface, technique, even ? "the same density everywhere" : "the density varies");
    return technique;
}

void TechniquePlan::log_choice(const Surface& surface, Technique technique, std::string_view reason) {
    const auto [found, is_new] = logged_.try_emplace({surface.entity.index, surface.entity.generation}, technique);
    if (!is_new && found->second == technique) return;
    found->second = technique;
    log::info("translucency: {}: auto takes {}: {}", surface.material->name,
              technique_names()[static_cast<size_t>(technique)], reason);
}

std::vector<size_t> TechniquePlan::surfaces(const RenderScene& scene, Technique technique) {
    std::vector<size_t> found;
    for (size_t i = 0; i < scene.surfaces.size(); ++i)
        if (is_translucent(scene.surfaces[i]) && technique_of(scene.surfaces[i]) == technique) found.push_back(i);
    return found;
}

}  // namespace tyndall::translucency
