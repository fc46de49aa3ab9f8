#include "translucent_surfaces.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

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
    return surface.mesh && surface.interior && !surface.diffusion && surface.interior->sigma_s_per_m != glm::vec3(0.0f);
}

bool scatters_once(const Wandering& wandering) {
    constexpr float kFewLengths = 1.2f, kLowAlbedo = 0.55f;
    return wandering.lengths < kFewLengths || wandering.albedo < kLowAlbedo;
}

Technique TechniquePlan::technique_of(const Surface& surface, const Camera& camera) {
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
    return automatic(surface, camera);
}

Technique TechniquePlan::automatic(const Surface& surface, const Camera& camera) {
    constexpr float kSmall = 0.02f, kSmallNoMore = 0.03f;  // of the picture's height; the second once it was small
    Choice& choice = choices_[{surface.entity.index, surface.entity.generation, surface.mesh->id}];
    const float distance = glm::distance(glm::vec3(camera.transform[3]), surface.bounds.centre());
    const float height = 2.0f * distance * std::tan(0.5f * camera.vertical_fov);
    const bool was_small = choice.logged && choice.technique == Technique::wrap;
    if (glm::length(surface.bounds.size()) < (was_small ? kSmallNoMore : kSmall) * height)
        log_choice(surface, choice, Technique::wrap, "seen small");
    else if (!std::holds_alternative<ConstantDensity>(surface.interior->density))
        log_choice(surface, choice, Technique::htsm, "the density varies");
    else if (scatters_once(wandering(surface, choice)))
        log_choice(surface, choice, Technique::htsm, "most light is scattered once");
    else
        log_choice(surface, choice, Technique::points, "light wanders in it, the same everywhere");
    return choice.technique;
}

Wandering TechniquePlan::wandering(const Surface& surface, Choice& choice) {
    choice.size.update(surface.mesh->mesh, glm::mat3(surface.transform));
    const Optics optics = optics_of(*surface.interior);
    const glm::vec3 albedo = optics.albedo();
    const auto largest = [](const glm::vec3& v) { return std::max({v.x, v.y, v.z}); };
    // what encloses nothing has no size to go by
    const float radius = choice.size.radius > 0.0f ? choice.size.radius : std::numeric_limits<float>::infinity();
    return {radius * largest(optics.sigma_s_reduced), largest(albedo)};
}

void TechniquePlan::log_choice(const Surface& surface, Choice& choice, Technique technique, std::string_view reason) {
    if (choice.logged && choice.technique == technique) return;
    choice.logged = true;
    choice.technique = technique;
    log::info("translucency: {}: auto takes {}: {}", surface.material->name,
              technique_names()[static_cast<size_t>(technique)], reason);
}

std::vector<size_t> TechniquePlan::surfaces(const RenderScene& scene, Technique technique) {
    std::vector<size_t> found;
    for (size_t i = 0; i < scene.surfaces.size(); ++i)
        if (is_translucent(scene.surfaces[i]) && technique_of(scene.surfaces[i], scene.camera) == technique)
            found.push_back(i);
    return found;
}

}  // namespace tyndall::translucency
