#include "medium_optics.h"

#include "physics/physics.h"

namespace tyndall::participating_media {
namespace {

Optics of_extinction(const glm::vec3& extinction, const glm::vec3& albedo) {
    return {albedo * extinction, (1.0f - albedo) * extinction};
}

}  // namespace

void describe(StructBuilder<CoefficientFields>& d) {
    d.doc("By scattering_per_m and absorption_per_m.");
}

void describe(StructBuilder<AlbedoMetres>& d) {
    using A = AlbedoMetres;
    d.doc("The share that a collision scatters, and how far light goes between collisions.");
    d.field("albedo", &A::albedo, "Single-scattering albedo per channel.").range(0.0, 1.0);
    d.field("mean_free_path_m", &A::mean_free_path_m, "1 / (scattering + absorption) per channel.")
        .unit("m")
        .range(1e-6, 1e9);
}

void describe(StructBuilder<ColourAtDistance>& d) {
    using C = ColourAtDistance;
    d.doc("What is left of white light after a distance, whether the rest was scattered or absorbed.");
    d.field("colour", &C::colour, "White light after at_m.").range(0.0, 1.0).colour();
    d.field("at_m", &C::at_m, "The distance.").unit("m").range(1e-6, 1e9);
    d.field("albedo", &C::albedo, "How much of what is lost was scattered.").range(0.0, 1.0);
}

std::vector<std::string> optics_names() {
    return {"coefficients", "albedo", "colour_at_distance"};
}

Optics make_optics(const OpticsChoice& choice, const Optics& fields) {
    if (const auto* by_albedo = std::get_if<AlbedoMetres>(&choice))
        return of_extinction(1.0f / by_albedo->mean_free_path_m, by_albedo->albedo);
    if (const auto* by_colour = std::get_if<ColourAtDistance>(&choice))
        return of_extinction(physics::sigma_t_from_color(by_colour->colour, by_colour->at_m), by_colour->albedo);
    return fields;
}

void describe(StructBuilder<BlackBody>& d) {
    using B = BlackBody;
    d.doc(
        "Adds the glow of what is hot: the absorption times a black body's radiance (Kirchhoff's law; Planck's law, "
        "Rec. 709 primaries).");
    d.field("temperature_k", &B::temperature_k, "Its temperature; with a grid, that of what the grid has as 0.")
        .unit("K")
        .range(0.0, 1e5);
    d.field("file", &B::file,
            "A volume whose values are the temperature, over the medium's box; empty = the file of the density.")
        .asset("volume");
    d.field("grid", &B::grid, "Which grid of an OpenVDB file; without file and grid it is as hot all over.");
    d.field("kelvin_per_unit", &B::kelvin_per_unit, "Multiplies the grid's values.").unit("K").range(0.0, 1e6);
}

}  // namespace tyndall::participating_media
