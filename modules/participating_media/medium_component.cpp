#include "medium_component.h"

#include "core/error.h"
#include "solver_plan.h"

namespace tyndall::participating_media {

void describe(StructBuilder<BoxBounds>& d) {
    d.doc("The unit box around the entity, scaled and turned by its transform.");
}
void describe(StructBuilder<WholeSceneBounds>& d) {
    d.doc("The bounding box of all surfaces, lights and the camera: fog without an end would let no sunlight in.");
}

namespace {
std::vector<std::string> solver_choices() {
    std::vector<std::string> names = solver_names();
    names.insert(names.begin(), "auto");
    return names;
}
}  // namespace

void describe(StructBuilder<MediumComponent>& d) {
    d.doc("A participating medium: air with fog, dust or smoke in it, or water. Overlapping media add.");
    d.field("bounds", &MediumComponent::bounds, "Where it is.", {"box", "whole_scene"});
    d.field("scattering_per_m", &MediumComponent::scattering_per_m, "Scattering coefficient per channel.")
        .unit("1/m")
        .range(0.0, 1e6);
    d.field("absorption_per_m", &MediumComponent::absorption_per_m, "Absorption coefficient per channel.")
        .unit("1/m")
        .range(0.0, 1e6);
    d.field("emission_cd_m2_per_m", &MediumComponent::emission_cd_m2_per_m, "Radiance given off per metre.")
        .unit("cd/m2/m")
        .range(0.0, 1e12);
    d.field("phase", &MediumComponent::phase, "How scattered light is spread over directions.", phase_names());
    d.field("density", &MediumComponent::density, "Multiplies the coefficients; places are in the unit box.",
            density_names());
    d.field("solver", &MediumComponent::solver,
            "What renders it in real time; auto chooses for each light. Documented in the module's README.",
            solver_choices());
}

void extract_medium(const ExtractContext& context, const void* component, RenderScene& scene) {
    const auto& authored = *static_cast<const MediumComponent*>(component);
    Medium medium;
    medium.entity = context.entity;
    medium.transform = context.transform;
    medium.shape = std::holds_alternative<BoxBounds>(authored.bounds) ? MediumShape::box : MediumShape::whole_scene;
    medium.sigma_s_per_m = authored.scattering_per_m;
    medium.sigma_a_per_m = authored.absorption_per_m;
    medium.emission_cd_m2_per_m = authored.emission_cd_m2_per_m;
    medium.phase = make_phase(authored.phase, context.assets);
    const auto* volume = std::get_if<VolumeDensity>(&authored.density);
    if (medium.shape == MediumShape::whole_scene && volume && volume->fit == VolumeFit::contain)
        throw Error("a volume that keeps its proportions needs a box: the whole scene's is not known beforehand");
    const Bounds unit_box{glm::vec3(-0.5f), glm::vec3(0.5f)};
    medium.density = make_density(authored.density, context.assets, unit_box, context.transform);
    medium.solver = solver_choices()[static_cast<size_t>(authored.solver)];
    scene.media.push_back(std::move(medium));
}

}  // namespace tyndall::participating_media
