#include "medium_component.h"

#include "core/error.h"
#include "physics/physics.h"
#include "solver_plan.h"

namespace tyndall::participating_media {
namespace {

std::vector<std::string> solver_choices() {
    std::vector<std::string> names = solver_names();
    names.insert(names.begin(), "auto");
    return names;
}

}  // namespace

void describe(StructBuilder<MediumComponent>& d) {
    d.doc("A participating medium: air with fog, dust or smoke in it, or water. Overlapping media add.");
    d.field("bounds", &MediumComponent::bounds, "Where it is.", bounds_names());
    d.field("optics", &MediumComponent::optics, "What it does to light.", optics_names());
    d.field("scattering_per_m", &MediumComponent::scattering_per_m, "Scattering coefficient per channel.")
        .unit("1/m")
        .range(0.0, 1e6);
    d.field("absorption_per_m", &MediumComponent::absorption_per_m, "Absorption coefficient per channel.")
        .unit("1/m")
        .range(0.0, 1e6);
    d.field("emission_cd_m2_per_m", &MediumComponent::emission_cd_m2_per_m, "Radiance given off per metre.")
        .unit("cd/m2/m")
        .range(0.0, 1e12);
    d.field("black_body", &MediumComponent::black_body, "The glow of a temperature.");
    d.field("phase", &MediumComponent::phase, "How scattered light is spread over directions.", phase_names());
    d.field("density", &MediumComponent::density, "Multiplies the coefficients; places are in the unit box.",
            density_names());
    d.field("scatter_factor", &MediumComponent::scatter_factor,
            "Not physical: multiplies the light that is scattered, and not what is lost. 1 = off.")
        .range(0.0, 1000.0);
    d.field("solver", &MediumComponent::solver,
            "What renders it in real time; auto chooses for each light. Documented in the module's README.",
            solver_choices());
}

namespace {

/// A density with what its bounds do to it; as simple as can be.
DensityField shaped(DensityField inside, const PlacedBounds& bounds) {
    if (!bounds.mask && !bounds.layer) return inside;
    if (std::holds_alternative<ConstantDensity>(inside)) {
        if (bounds.mask) return *bounds.mask;
        return *bounds.layer;
    }
    return ProductDensity{std::make_shared<const DensityField>(std::move(inside)), bounds.mask, bounds.layer};
}

void add_black_body(const MediumComponent& authored, AssetStore& assets, const VolumePlace& place, Medium& medium) {
    const BlackBody& from = authored.black_body;
    if (from.grid.empty() && from.file.empty()) {
        medium.emission_cd_m2_per_m += medium.sigma_a_per_m * physics::black_body_radiance(from.temperature_k);
        return;
    }
    const auto* density = std::get_if<VolumeDensity>(&authored.density);
    if (from.file.empty() && !density)
        throw Error("the black body's grid '" + from.grid +
                    "' is in no file (expected its file, or a density from a volume)");
    VolumeDensity volume;
    if (from.file.empty())
        volume = *density;
    else
        volume.file = from.file;
    TemperatureField field{placed_volume(volume, from.grid, assets, place), from.temperature_k};
    field.grid.scale = from.kelvin_per_unit;
    medium.temperature = std::move(field);
}

}  // namespace

void extract_medium(const ExtractContext& context, const void* component, RenderScene& scene) {
    const auto& authored = *static_cast<const MediumComponent*>(component);
    const PlacedBounds bounds = place_bounds(authored.bounds, context);
    Medium medium;
    medium.entity = context.entity;
    medium.transform = bounds.transform;
    medium.shape = bounds.shape;
    medium.layer_low_m = bounds.low_m, medium.layer_high_m = bounds.high_m;
    const Optics optics = make_optics(authored.optics, {authored.scattering_per_m, authored.absorption_per_m});
    medium.sigma_s_per_m = optics.sigma_s;
    medium.sigma_a_per_m = optics.sigma_a;
    medium.emission_cd_m2_per_m = authored.emission_cd_m2_per_m;
    medium.scatter_factor = authored.scatter_factor;
    medium.phase = make_phase(authored.phase, context.assets);
    const auto* volume = std::get_if<VolumeDensity>(&authored.density);
    if (bounds.whole() && volume && volume->fit == VolumeFit::contain)
        throw Error("a volume that keeps its proportions needs a box: the whole scene's is not known beforehand");
    const VolumePlace place{{glm::vec3(-0.5f), glm::vec3(0.5f)}, bounds.transform, scene.time_s};
    medium.density = shaped(make_density(authored.density, context.assets, place), bounds);
    add_black_body(authored, context.assets, place, medium);
    medium.solver = solver_choices()[static_cast<size_t>(authored.solver)];
    scene.media.push_back(std::move(medium));
}

}  // namespace tyndall::participating_media
