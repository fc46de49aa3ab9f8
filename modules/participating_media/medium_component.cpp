#include "medium_component.h"

#include "physics/physics.h"

namespace tyndall::participating_media {
namespace {

constexpr double kMostForward = 0.99;

template <class... F>
struct Overloaded : F... {
    using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;

void set_phase(Medium& medium, PhaseKind kind, const glm::vec4& parameters) {
    medium.phase = {.kind = kind, .parameters = parameters, .table = nullptr};
}

}  // namespace

void describe(StructBuilder<BoxBounds>& d) {
    d.doc("The unit box around the entity, scaled and turned by its transform.");
}
void describe(StructBuilder<WholeSceneBounds>& d) {
    d.doc("The bounding box of all surfaces, lights and the camera: fog without an end would let no sunlight in.");
}
void describe(StructBuilder<IsotropicPhase>& d) {
    d.doc("Scatters equally in all directions.");
}
void describe(StructBuilder<RayleighPhase>& d) {
    d.doc("Particles much smaller than the wavelength (Rayleigh 1871).");
}

void describe(StructBuilder<HenyeyGreensteinPhase>& d) {
    d.doc("One lobe (Henyey & Greenstein 1941).");
    d.field("g", &HenyeyGreensteinPhase::g, "Mean cosine; positive scatters forward.")
        .range(-kMostForward, kMostForward);
}

void describe(StructBuilder<SchlickPhase>& d) {
    d.doc("Schlick's rational approximation of Henyey-Greenstein, a little cheaper (Blasi et al. 1993).");
    d.field("g", &SchlickPhase::g, "The g of the Henyey-Greenstein lobe that it resembles.")
        .range(-kMostForward, kMostForward);
}

void describe(StructBuilder<CornetteShanksPhase>& d) {
    d.doc("Henyey-Greenstein that becomes Rayleigh's function as g goes to 0 (Cornette & Shanks 1992).");
    d.field("g", &CornetteShanksPhase::g, "Asymmetry; positive scatters forward.").range(-kMostForward, kMostForward);
}

void describe(StructBuilder<TwoLobePhase>& d) {
    d.doc("A forward and a backward Henyey-Greenstein lobe.");
    d.field("g0", &TwoLobePhase::g0, "Mean cosine of the first lobe.").range(-kMostForward, kMostForward);
    d.field("g1", &TwoLobePhase::g1, "Mean cosine of the second lobe.").range(-kMostForward, kMostForward);
    d.field("weight", &TwoLobePhase::weight, "Share of the second lobe.").range(0.0, 1.0);
}

void describe(StructBuilder<WaterDropletPhase>& d) {
    d.doc("Fog and cloud droplets: a fit of Mie scattering (Jendersie & d'Eon 2023).");
    d.field("diameter_um", &WaterDropletPhase::diameter_um, "Diameter of the droplets.").unit("um").range(5.0, 50.0);
}

void describe(StructBuilder<MediumComponent>& d) {
    d.doc("A homogeneous participating medium: air with fog, dust or smoke in it, or water. Overlapping media add.");
    d.field("bounds", &MediumComponent::bounds, "Where it is.", {"box", "whole_scene"});
    d.field("scattering_per_m", &MediumComponent::scattering_per_m, "Scattering coefficient per channel.")
        .unit("1/m")
        .range(0.0, 1e6);
    d.field("absorption_per_m", &MediumComponent::absorption_per_m, "Absorption coefficient per channel.")
        .unit("1/m")
        .range(0.0, 1e6);
    d.field("phase", &MediumComponent::phase, "How scattered light is spread over directions.",
            {"isotropic", "henyey_greenstein", "schlick", "rayleigh", "cornette_shanks", "two_lobe", "water_droplets"});
}

void extract_medium(const ExtractContext& context, const void* component, RenderScene& scene) {
    const auto& authored = *static_cast<const MediumComponent*>(component);
    Medium medium;
    medium.entity = context.entity;
    medium.transform = context.transform;
    medium.shape = std::holds_alternative<BoxBounds>(authored.bounds) ? MediumShape::box : MediumShape::whole_scene;
    medium.sigma_s_per_m = authored.scattering_per_m;
    medium.sigma_a_per_m = authored.absorption_per_m;
    std::visit(Overloaded{
                   [&](const IsotropicPhase&) { set_phase(medium, PhaseKind::isotropic, {}); },
                   [&](const RayleighPhase&) { set_phase(medium, PhaseKind::rayleigh, {}); },
                   [&](const HenyeyGreensteinPhase& p) {
                       set_phase(medium, PhaseKind::henyey_greenstein, {p.g, 0, 0, 0});
                   },
                   [&](const SchlickPhase& p) {
                       set_phase(medium, PhaseKind::schlick, {physics::schlick_k_from_g(p.g), 0, 0, 0});
                   },
                   [&](const CornetteShanksPhase& p) {
                       set_phase(medium, PhaseKind::cornette_shanks, {p.g, 0, 0, 0});
                   },
                   [&](const TwoLobePhase& p) {
                       set_phase(medium, PhaseKind::two_lobe, {p.g0, p.g1, p.weight, 0});
                   },
                   [&](const WaterDropletPhase& p) {
                       set_phase(medium, PhaseKind::mie_droplets, physics::mie_droplet_fit(p.diameter_um));
                   },
               },
               authored.phase);
    scene.media.push_back(medium);
}

}  // namespace tyndall::participating_media
