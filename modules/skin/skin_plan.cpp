#include "skin_plan.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

#include "texture_space/surface_finish.h"

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

bool has_volume(const Surface& surface) {
    const float volume = glm::determinant(glm::mat3(surface.transform));
    return volume != 0.0f && std::isfinite(volume);
}

float thickness_use(const SurfaceDiffusion& diffusion) {
    if (!diffusion.thickness || !(diffusion.transmission > 0.0f)) return 0.0f;
    return diffusion.thickness->all_lights ? 2.0f : 1.0f;
}

bool scatters_colour(const Surface& surface) {
    const Technique technique = technique_of(*surface.diffusion);
    const bool on_screen = technique >= Technique::two_gaussians && technique <= Technique::disc;
    return on_screen && usable_pre_scatter(*surface.material, surface.diffusion->pre_scatter) > 0.0f;
}

std::vector<size_t> surfaces_of(const RenderScene& scene, Technique technique) {
    std::vector<size_t> found;
    for (size_t i = 0; i < scene.surfaces.size(); ++i)
        if (scene.surfaces[i].diffusion && technique_of(*scene.surfaces[i].diffusion) == technique) found.push_back(i);
    return found;
}

}  // namespace tyndall::skin
