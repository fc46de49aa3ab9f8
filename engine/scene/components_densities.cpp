#include "core/error.h"
#include "scene/scattering_components.h"

namespace tyndall {

void describe(StructBuilder<ConstantDensity>& d) {
    d.doc("The same everywhere.");
}

void describe(StructBuilder<HeightDensity>& d) {
    d.doc("Falls with the height in the world, exp(-(y - base_m) / scale_height_m), as ground fog and the air do.");
    d.field("base_m", &HeightDensity::base_m, "Height at which the density is 1.").unit("m").range(-1e6, 1e6);
    d.field("scale_height_m", &HeightDensity::scale_height_m, "Over this height it falls to 37 %.")
        .unit("m")
        .range(1e-3, 1e6);
}

void describe(StructBuilder<BlobDensity::Blob>& d) {
    using B = BlobDensity::Blob;
    d.doc("weight exp(-distance^2 / (2 radius^2)), in the unit box of a medium or the space of a mesh.");
    d.field("centre", &B::centre, "Its middle.").range(-1e6, 1e6);
    d.field("radius", &B::radius, "Standard deviation.").range(1e-6, 1e6);
    d.field("weight", &B::weight, "Density in its middle.").range(0.0, 1e6);
}

void describe(StructBuilder<BlobDensity>& d) {
    d.doc("A sum of Gaussian blobs.");
    d.field("blobs", &BlobDensity::blobs, "The blobs.");
}

void describe(StructBuilder<NoiseDensity>& d) {
    d.doc("Fractal noise between 0 and 1, fixed in the world: clouds and drifting smoke.");
    d.field("kind", &NoiseDensity::kind, "perlin: waves; worley: round puffs, at four times the cost.",
            {"perlin", "worley"});
    d.field("feature_m", &NoiseDensity::feature_m, "Size of the largest features.").unit("m").range(1e-4, 1e6);
    d.field("octaves", &NoiseDensity::octaves,
            "Levels of detail, each half as large and half as strong; time grows with them.")
        .range(1, 16);
    d.field("coverage", &NoiseDensity::coverage, "Share of space that is not empty, roughly.").range(0.0, 1.0);
    d.field("wind_m_s", &NoiseDensity::wind_m_s, "Moves it with the time.").unit("m/s").range(-1e3, 1e3);
    d.field("swirl", &NoiseDensity::swirl, "Curl noise displaces it by about so many features; 0 costs nothing.")
        .range(0.0, 8.0);
    d.field("churn_per_s", &NoiseDensity::churn_per_s, "How fast the swirls change, in features a second.")
        .unit("1/s")
        .range(-100.0, 100.0);
}

void describe(StructBuilder<LinearGradient>& d) {
    using G = LinearGradient;
    d.doc("A ramp between two places in the unit box of a medium or the space of a mesh.");
    d.field("from", &G::from, "Where it starts.").range(-1e6, 1e6);
    d.field("to", &G::to, "Where it ends.").range(-1e6, 1e6);
    d.field("start", &G::start, "Density at the start and before it.").range(0.0, 1e6);
    d.field("end", &G::end, "Density at the end and beyond it.").range(0.0, 1e6);
}

void describe(StructBuilder<RadialGradient>& d) {
    using G = RadialGradient;
    d.doc("A ramp away from a centre, in the unit box of a medium or the space of a mesh.");
    d.field("centre", &G::centre, "The centre.").range(-1e6, 1e6);
    d.field("inner_radius", &G::inner_radius, "Where it starts.").range(0.0, 1e6);
    d.field("outer_radius", &G::outer_radius, "Where it ends.").range(0.0, 1e6);
    d.field("start", &G::start, "Density at the centre.").range(0.0, 1e6);
    d.field("end", &G::end, "Density outside.").range(0.0, 1e6);
}

std::vector<std::string> density_names() {
    return {"constant", "height", "blobs", "noise", "volume", "linear_gradient", "radial_gradient"};
}

namespace {

/// What a choice becomes; a volume is placed in the box.
struct MakeDensity {
    const VolumePlace& place;
    AssetStore& assets;

    DensityField operator()(const VolumeDensity& volume) const {
        return placed_volume(volume, volume.grid, assets, place);
    }
    DensityField operator()(const LinearGradient& g) const {
        return GradientDensity{.from = g.from, .to = g.to, .start = g.start, .end = g.end};
    }
    DensityField operator()(const RadialGradient& g) const {
        if (!(g.inner_radius < g.outer_radius))
            throw Error("a radial gradient's outer_radius must be above its inner_radius");
        return GradientDensity{.radial = true,
                               .from = g.centre,
                               .inner = g.inner_radius,
                               .outer = g.outer_radius,
                               .start = g.start,
                               .end = g.end};
    }
    template <class Same>
    DensityField operator()(const Same& density) const {
        return density;
    }
};

}  // namespace

DensityField make_density(const DensityChoice& choice, AssetStore& assets, const VolumePlace& place) {
    return std::visit(MakeDensity{place, assets}, choice);
}

}  // namespace tyndall
