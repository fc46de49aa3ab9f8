#include "translucent_surfaces.h"

#include <algorithm>

#include "core/error.h"
#include "core/log.h"
#include "scene/field_reader.h"

namespace tyndall::translucency {

const std::vector<std::string>& technique_names() {
    static const std::vector<std::string> kNames{"plain", "points"};
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
    return Technique::points;
}

std::vector<size_t> TechniquePlan::surfaces(const RenderScene& scene, Technique technique) {
    std::vector<size_t> found;
    for (size_t i = 0; i < scene.surfaces.size(); ++i)
        if (is_translucent(scene.surfaces[i]) && technique_of(scene.surfaces[i]) == technique) found.push_back(i);
    return found;
}

}  // namespace tyndall::translucency
