#include <cmath>

#include "physics/half_space.h"
#include "scene/scattering_components.h"

namespace tyndall {
namespace {

/// The absorption that leaves `colour` of white light after a distance; none for a distance of 0, which means infinite.
glm::vec3 absorption_from_colour(const glm::vec3& colour, float distance_m) {
    if (!(distance_m > 0.0f) || std::isinf(distance_m)) return glm::vec3(0.0f);
    return -glm::log(glm::clamp(colour, glm::vec3(1e-6f), glm::vec3(1.0f))) / distance_m;
}

template <int PerMetre>
void set_optics(const Coefficients<PerMetre>& from, ScatteringInterior& to) {
    constexpr float kPerM = PerMetre;
    to.sigma_a_per_m = kPerM * from.absorption;
    to.sigma_s_per_m = kPerM * from.scattering;
    if (from.reduced) to.sigma_s_per_m /= glm::max(1.0f - mean_cosine(to.phase), glm::vec3(1e-3f));
}

void set_optics(const AlbedoOptics& from, ScatteringInterior& to) {
    const glm::vec3 extinction = 1000.0f / from.mean_free_path_mm;
    to.sigma_s_per_m = from.albedo * extinction;
    to.sigma_a_per_m = extinction - to.sigma_s_per_m;
}

void set_optics(const TransmissionColourOptics& from, ScatteringInterior& to) {
    to.sigma_a_per_m = absorption_from_colour(from.colour, from.at_m);
}

/// Light that is scattered many times dies away as exp(-k d), where k, over the extinction, is Case's eigenvalue x of
/// the albedo: albedo = 2 x / ln((1 + x) / (1 - x)) (Case & Zweifel, Linear Transport Theory, 1967, 4.2; isotropic,
/// or reduced). So x = tanh(k / scattering): exact from clear to milky, where diffusion theory holds near 1 alone.
void set_optics(const TransportColourOptics& from, ScatteringInterior& to) {
    const glm::vec3 reduced = 1000.0f / from.mean_free_path_mm;
    const glm::vec3 decay = absorption_from_colour(from.colour, from.at_m);
    const glm::vec3 share = glm::max(decay / reduced, glm::vec3(1e-20f));
    // k / tanh(k / s) - s, without what cancels where k is small
    const glm::vec3 series = share * share / 3.0f;
    const glm::vec3 exact = share / glm::tanh(share) - 1.0f;
    to.sigma_a_per_m = reduced * glm::mix(exact, series, glm::lessThan(share, glm::vec3(0.02f)));
    to.sigma_s_per_m = reduced / glm::max(1.0f - mean_cosine(to.phase), glm::vec3(1e-3f));
}

template <int PerMetre>
void describe_coefficients(StructBuilder<Coefficients<PerMetre>>& d, const char* unit) {
    using C = Coefficients<PerMetre>;
    const double most = 1e9 / PerMetre;
    d.field("scattering", &C::scattering, "Scattering coefficient per channel.").unit(unit).range(0.0, most);
    d.field("absorption", &C::absorption, "Absorption coefficient per channel.").unit(unit).range(0.0, most);
    d.field("reduced", &C::reduced,
            "The scattering is the reduced one of most tables: it is divided by 1 - the phase's mean cosine.");
}

}  // namespace

void describe(StructBuilder<CoefficientsPerM>& d) {
    d.doc("Coefficients per metre.");
    describe_coefficients(d, "1/m");
}

void describe(StructBuilder<CoefficientsPerMm>& d) {
    d.doc("Coefficients per millimetre, as tables of materials have them.");
    describe_coefficients(d, "1/mm");
}

void describe(StructBuilder<AlbedoOptics>& d) {
    d.doc("The share that a collision scatters, and how far light goes between collisions.");
    d.field("albedo", &AlbedoOptics::albedo, "Single-scattering albedo per channel.").range(0.0, 1.0);
    d.field("mean_free_path_mm", &AlbedoOptics::mean_free_path_mm, "1 / (scattering + absorption) per channel.")
        .unit("mm")
        .range(1e-6, 1e9);
}

void describe(StructBuilder<TransmissionColourOptics>& d) {
    d.doc("Clear and coloured, as glass: what is left of white light after a distance. Scatters nothing.");
    d.field("colour", &TransmissionColourOptics::colour, "White light after at_m.").range(0.0, 1.0).colour();
    d.field("at_m", &TransmissionColourOptics::at_m, "The distance.").unit("m").range(1e-6, 1e6);
}

void describe(StructBuilder<TransportColourOptics>& d) {
    using O = TransportColourOptics;
    d.doc("Milky and coloured: what light that is scattered many times looks like after a distance.");
    d.field("colour", &O::colour, "What is left of white light after at_m, far from where it entered.")
        .range(0.0, 1.0)
        .colour();
    d.field("at_m", &O::at_m, "The distance.").unit("m").range(1e-6, 1e6);
    d.field("mean_free_path_mm", &O::mean_free_path_mm,
            "1 / the reduced scattering per channel: how far light goes before it has lost its direction.")
        .unit("mm")
        .range(1e-6, 1e9);
}

void describe(StructBuilder<InteriorPaint>& d) {
    using P = InteriorPaint;
    d.doc(
        "A diffuse layer over what is inside, under the boundary's mirror: what it covers lets no light in or out, and "
        "throws light back on both sides.");
    d.field("cover", &P::cover, "Share of the surface that is painted; 0 = no paint.").range(0.0, 1.0);
    d.field("colour", &P::colour, "What it throws back of white light.").range(0.0, 1.0).colour();
    d.field("texture", &P::texture, "A picture: its alpha multiplies the cover, its colour the colour.")
        .asset("texture");
}

void describe(StructBuilder<InteriorComponent>& d) {
    using I = InteriorComponent;
    d.doc(
        "What is inside the entity's closed meshes (its mesh, or all of its gltf), behind a dielectric boundary that "
        "takes the place of the material. The reference path tracer shows it.");
    d.field("optics", &I::optics, "What scatters and absorbs.",
            {"coefficients_per_mm", "coefficients_per_m", "albedo", "transmission_colour", "transport_colour"});
    d.field("phase", &I::phase, "How scattered light is spread over directions.", phase_names());
    d.field("density", &I::density, "Multiplies the coefficients; places are in the mesh's space.", density_names());
    d.field("emission_cd_m2_per_m", &I::emission_cd_m2_per_m, "Radiance given off per metre.")
        .unit("cd/m2/m")
        .range(0.0, 1e12);
    d.field("ior", &I::ior, "Index of refraction; 1 lets light pass the boundary unbent.").range(1.0, 4.0);
    d.field("roughness", &I::roughness, "Perceptual roughness of the boundary; 0 = smooth.").range(0.0, 1.0);
    d.field("paint", &I::paint, "What is painted over it, of interiors that scatter.");
    d.field("priority", &I::priority, "Where interiors overlap, the highest is there and the others are not.")
        .range(-1000, 1000);
    d.field("technique", &I::technique,
            "What renders it in real time, by the names of the module translucency; auto chooses.");
}

ScatteringInterior make_interior(const InteriorComponent& from, AssetStore& assets, const VolumePlace& place) {
    ScatteringInterior interior;
    interior.phase = make_phase(from.phase, assets);
    std::visit([&](const auto& optics) { set_optics(optics, interior); }, from.optics);
    interior.emission_cd_m2_per_m = from.emission_cd_m2_per_m;
    interior.density = make_density(from.density, assets, place);
    interior.eta = from.ior;
    interior.roughness = from.roughness;
    interior.priority = from.priority;
    interior.technique = from.technique;
    return interior;
}

Material boundary_material(const ScatteringInterior& interior, const std::string& name) {
    const glm::vec3 reduced = interior.sigma_s_per_m * (glm::vec3(1.0f) - mean_cosine(interior.phase));
    const glm::vec3 extinction = glm::max(reduced + interior.sigma_a_per_m, glm::vec3(1e-6f));
    Material material;
    material.id = new_asset_id();
    material.name = name;
    material.base_colour = glm::vec4(physics::HalfSpace(reduced / extinction, interior.eta).diffuse_leaving(), 1.0f);
    material.roughness = interior.roughness;
    material.ior = interior.eta;
    material.specular = interior.eta > 1.0f ? 1.0f : 0.0f;
    material.shading_model = "interior";  // standard where no module brings it
    return material;
}

std::optional<ScatteringInterior> interior_of_material(const Material& material) {
    if (material.transmission != 1.0f || material.transmission_texture.texture || !(material.thickness_m > 0.0f))
        return std::nullopt;
    ScatteringInterior interior;
    interior.sigma_a_per_m = absorption_from_colour(material.attenuation_colour, material.attenuation_distance_m);
    interior.eta = material.ior;
    interior.roughness = material.roughness;
    return interior;
}

}  // namespace tyndall
