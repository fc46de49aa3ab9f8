#include "skin_plan.h"

#include <algorithm>

namespace tyndall::skin {

const std::vector<std::string>& technique_names() {
    static const std::vector<std::string> kNames{"lambert",       "wrap",          "blurred_normals",
                                                 "preintegrated", "two_gaussians", "separable",
                                                 "disc",          "six_gaussians", "hable"};
    return kNames;
}

Technique technique_of(const SurfaceDiffusion& diffusion) {
    const std::vector<std::string>& names = technique_names();
    const auto found = std::ranges::find(names, diffusion.technique);
    return found == names.end() ? Technique::separable : static_cast<Technique>(found - names.begin());
}

std::vector<size_t> surfaces_of(const RenderScene& scene, Technique technique) {
    std::vector<size_t> found;
    for (size_t i = 0; i < scene.surfaces.size(); ++i)
        if (scene.surfaces[i].diffusion && technique_of(*scene.surfaces[i].diffusion) == technique) found.push_back(i);
    return found;
}

}  // namespace tyndall::skin
