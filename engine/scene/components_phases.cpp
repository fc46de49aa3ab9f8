#include "core/error.h"
#include "physics/physics.h"
#include "scene/scattering_components.h"

namespace tyndall {
namespace {

constexpr double kMostForward = 0.99;

PhaseFunction phase_of(PhaseKind kind, const glm::vec4& parameters) {
    return {.kind = kind, .parameters = parameters, .table = nullptr};
}

PhaseFunction made(const IsotropicPhase&) {
    return phase_of(PhaseKind::isotropic, {});
}
PhaseFunction made(const RayleighPhase&) {
    return phase_of(PhaseKind::rayleigh, {});
}
PhaseFunction made(const HenyeyGreensteinPhase& p) {
    return phase_of(PhaseKind::henyey_greenstein, {p.g, 0, 0, 0});
}
PhaseFunction made(const SchlickPhase& p) {
    return phase_of(PhaseKind::schlick, {physics::schlick_k_from_g(p.g), 0, 0, 0});
}
PhaseFunction made(const CornetteShanksPhase& p) {
    return phase_of(PhaseKind::cornette_shanks, {p.g, 0, 0, 0});
}
PhaseFunction made(const TwoLobePhase& p) {
    return phase_of(PhaseKind::two_lobe, {p.g0, p.g1, p.weight, 0});
}
PhaseFunction made(const WaterDropletPhase& p) {
    return phase_of(PhaseKind::mie_droplets, physics::mie_droplet_fit(p.diameter_um));
}
PhaseFunction made(const DrainePhase& p) {
    return phase_of(PhaseKind::draine, {p.g, p.a, 0, 0});
}

/// Mean cosine of a table, by the trapezoidal rule on a fine grid of its linear pieces.
glm::vec3 mean_cosine_of(const PhaseTable& table) {
    constexpr int kParts = 16;
    const size_t pieces = table.values.size() - 1;
    const double step = glm::pi<double>() / static_cast<double>(pieces * kParts);
    glm::dvec3 sum(0.0);
    for (size_t i = 0; i < pieces * kParts; ++i) {
        const double angle = (static_cast<double>(i) + 0.5) * step;
        const double part = (static_cast<double>(i % kParts) + 0.5) / kParts;
        const glm::dvec3 value =
            glm::mix(glm::dvec3(table.values[i / kParts]), glm::dvec3(table.values[i / kParts + 1]), part);
        sum += value * std::sin(angle) * std::cos(angle);
    }
    return glm::vec3(glm::two_pi<double>() * step * sum);
}

}  // namespace

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

void describe(StructBuilder<DrainePhase>& d) {
    d.doc("Henyey-Greenstein times 1 + a cos^2 (Draine 2003): dust; a = 1 is Cornette-Shanks.");
    d.field("g", &DrainePhase::g, "Asymmetry; positive scatters forward.").range(-kMostForward, kMostForward);
    d.field("a", &DrainePhase::a, "0 = Henyey-Greenstein; large = a backward lobe too.").range(0.0, 1e4);
}

void describe(StructBuilder<TabulatedPhase>& d) {
    d.doc("Measured or computed: a text file of lines `angle_deg value` or `angle_deg red green blue`.");
    d.field("file", &TabulatedPhase::file, "The table, relative to the scene; normalised when it is read.")
        .asset("phase");
}

std::vector<std::string> phase_names() {
    return {"isotropic", "henyey_greenstein", "schlick", "rayleigh", "cornette_shanks",
            "two_lobe",  "water_droplets",    "draine",  "tabulated"};
}

PhaseFunction make_phase(const PhaseChoice& choice, AssetStore& assets) {
    return std::visit(
        [&](const auto& phase) -> PhaseFunction {
            if constexpr (std::is_same_v<std::decay_t<decltype(phase)>, TabulatedPhase>) {
                if (phase.file.empty()) throw Error("a tabulated phase function needs a file");
                return {.kind = PhaseKind::tabulated, .parameters = {}, .table = assets.phase_table(phase.file)};
            } else {
                return made(phase);
            }
        },
        choice);
}

glm::vec3 mean_cosine(const PhaseFunction& phase) {
    if (phase.kind == PhaseKind::tabulated) return phase.table ? mean_cosine_of(*phase.table) : glm::vec3(0.0f);
    return glm::vec3(physics::phase_mean_cosine(static_cast<int>(phase.kind), phase.parameters));
}

}  // namespace tyndall
