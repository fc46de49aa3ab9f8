// Light in layers of a solid: models of diffusion against each other and against photons.

#include <array>
#include <cmath>

#include "photons.h"
#include "physics/hankel.h"
#include "physics/layered_diffusion.h"
#include "physics/skin_profiles.h"
#include "physics/slab_transmittance.h"
#include "physics_test.h"

namespace tyndall::physics {
namespace {

using Layers = std::vector<SolidLayer>;

SolidLayer slab(SolidLayer layer, double thickness_m) {
    layer.thickness_m = thickness_m;
    return layer;
}

TEST(Multipole, ThickLayerIsTheStandardDipole) {
    double worst = 0.0;
    for (const SolidLayer& skin : {slab(jensen_skin1(), 0.1), jensen_skin2()}) {
        const Diffusion m = make_diffusion(vec3(skin.sigma_s_reduced), vec3(skin.sigma_a), 0.0f, float(skin.eta));
        for (double r = 1e-5; r < 5e-3; r *= 1.7) {
            const dvec3 found = inverse_hankel(
                [&](double k) {
                    return multipole_response({&skin, 1}, k).reflected;
                },
                r);
            const dvec3 ratio = found / dvec3(standard_dipole(m, float(r)));
            for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(ratio[c] - 1.0));
        }
    }
    measured("multipole of a thick layer against the standard dipole, worst relative error", worst);
    EXPECT_LT(worst, 0.01);
}

TEST(Multipole, IsTheSumOfItsImages) {
    const SolidLayer layer = slab(jensen_skin2(), 3e-3);
    const double sigma_t = layer.sigma_a.x + layer.sigma_s_reduced.x,
                 sigma_tr = std::sqrt(3.0 * layer.sigma_a.x * sigma_t);
    const double l = 1.0 / sigma_t, zb = 2.0 * boundary_parameter(layer.eta) / (3.0 * sigma_t);
    const double period = 2.0 * (layer.thickness_m + 2.0 * zb);
    const auto flux = [&](double z, double r) {
        const double d = std::hypot(z, r);
        return z * (1.0 + sigma_tr * d) * std::exp(-sigma_tr * d) / (4.0 * double(kPi) * d * d * d);
    };
    for (const double r : {1e-4, 1e-3, 5e-3}) {
        dvec3 found(0.0);  // above and below, through one function
        found = inverse_hankel(
            [&](double k) {
                const SolidResponse at = multipole_response({&layer, 1}, k);
                return dvec3(at.reflected.x, at.transmitted.x, 0.0);
            },
            r);
        double above = 0.0, below = 0.0;
        for (int i = -40; i <= 40; ++i) {
            const double real = i * period + l, mirrored = i * period - l - 2.0 * zb, d = layer.thickness_m;
            above += flux(real, r) - flux(mirrored, r);
            below += flux(d - real, r) - flux(d - mirrored, r);
        }
        const double albedo = layer.sigma_s_reduced.x / sigma_t;
        EXPECT_NEAR(found.x, albedo * above, 2e-3 * albedo * above);
        EXPECT_NEAR(found.y, albedo * below, 2e-3 * albedo * below);
    }
}

TEST(LayeredDiffusion, TwoHalvesAreOneWhole) {
    double worst = 0.0, worst_multipole = 0.0;
    for (const double d : {1e-4, 1e-3, 4e-3})
        for (const double k : {0.0, 500.0, 5000.0}) {
            const Layers whole{slab(jensen_skin1(), d)}, halves(2, slab(jensen_skin1(), 0.5 * d));
            const SolidResponse one = layered_response(whole, k), two = layered_response(halves, k);
            const SolidResponse images = multipole_response(whole, k), both = multipole_response(halves, k);
            for (int c = 0; c < 3; ++c) {
                worst = std::max(worst, std::abs(one.reflected[c] - two.reflected[c]));
                worst = std::max(worst, std::abs(one.transmitted[c] - two.transmitted[c]));
                worst_multipole = std::max(worst_multipole, std::abs(images.reflected[c] - both.reflected[c]));
            }
        }
    measured("two halves against one layer, worst", worst);
    measured("the same by the multipole as published, worst", worst_multipole);
    EXPECT_LT(worst, 1e-8);
}

TEST(LayeredDiffusion, NothingIsGained) {
    Random random(4);
    double lost = 0.0;
    for (int i = 0; i < 3000; ++i) {
        Layers layers;
        for (int n = 0; n < 1 + i % 3; ++n) {
            SolidLayer layer;
            layer.thickness_m = std::exp(double(random.between(-12, 0)));
            layer.sigma_s_reduced = dvec3(std::exp(random.between(0, 10)));
            layer.sigma_a = dvec3(0.0, std::exp(random.between(-4, 8)), i % 5 == 0 ? 0.0 : 1e3);
            layer.eta = double(random.between(1.0f, 1.8f));
            layers.push_back(layer);
        }
        const SolidResponse at = layered_response(layers, 0.0);
        const dvec3 sum = at.reflected + at.transmitted;
        for (int c = 0; c < 3; ++c) {
            ASSERT_GE(at.reflected[c], -1e-9) << i;
            ASSERT_GE(at.transmitted[c], -1e-9) << i;
            ASSERT_LT(sum[c], 1.0 + 1e-6) << i;
        }
        lost = std::max(lost, std::abs(1.0 - sum.x));
    }
    measured("loss in layers that absorb nothing, worst", lost);
    EXPECT_LT(lost, 1e-3);
}

/// Reflected and transmitted of a slab or stack against photons; prints, and returns the worst error of
/// layered_response.
double against_photons(const char* name, const Layers& layers, int photons) {
    const SolidResponse found = layered_response(layers, 0.0), images = multipole_response(layers, 0.0);
    double worst = 0.0;
    for (int c = 0; c < 3; ++c) {
        const PhotonCount traced = PhotonTrace(layers, c, 5).run(photons);
        std::printf("%-12s %c: photons R %.4f T %.4f, layered R %.4f T %.4f, multipole R %.4f T %.4f\n", name, "rgb"[c],
                    traced.reflected, traced.transmitted, found.reflected[c], found.transmitted[c], images.reflected[c],
                    images.transmitted[c]);
        EXPECT_NEAR(traced.reflected + traced.transmitted + traced.absorbed, 1.0, 0.01);
        worst = std::max(worst, std::abs(found.reflected[c] - traced.reflected));
        worst = std::max(worst, std::abs(found.transmitted[c] - traced.transmitted));
    }
    return worst;
}

TEST(LayeredDiffusion, TotalsAreThoseOfPhotons) {
    double worst = 0.0;
    for (const double mm : {0.5, 1.0, 2.0, 5.0})
        worst = std::max(worst, against_photons(mm < 1.0   ? "skin1 0.5 mm"
                                                : mm < 2.0 ? "skin1 1 mm"
                                                : mm < 5.0 ? "skin1 2 mm"
                                                           : "skin1 5 mm",
                                                {slab(jensen_skin1(), mm * 1e-3)}, 10000));
    worst = std::max(worst, against_photons("three layers", three_layer_skin(), 10000));
    measured("share reflected or transmitted against photons, worst", worst);
    EXPECT_LT(worst, 0.045);
}

double edge_rms(const PhotonCount& traced, const RadialProfile& model, int channel, double width) {
    double sum = 0.0;
    int places = 0;
    for (double x = 0.02 * width; x < 1.5 * width; x *= 1.3, ++places)
        sum += std::pow(model.edge(x)[channel] - traced.edge(x), 2.0);
    return std::sqrt(sum / places);
}

TEST(SolidExitance, EdgesAreThoseOfPhotons) {
    const std::array<std::pair<const char*, Layers>, 4> solids{{{"skin1", {jensen_skin1()}},
                                                                {"skin2", {jensen_skin2()}},
                                                                {"skin1, 1 mm", {slab(jensen_skin1(), 1e-3)}},
                                                                {"three layers", three_layer_skin()}}};
    for (const auto& [name, layers] : solids) {
        const RadialProfile model(solid_exitance(layers));
        const Diffusion m = make_diffusion(vec3(layers[0].sigma_s_reduced), vec3(layers[0].sigma_a), 0.0f, 1.3f);
        const RadialProfile standard([&](double r) { return dvec3(standard_dipole(m, float(r))); });
        for (int c = 0; c < 3; ++c) {
            PhotonCount traced = PhotonTrace(layers, c, 8).run(20000);
            const double width = traced.edge_width(), off = edge_rms(traced, model, c, width);
            std::printf(
                "%-12s %c: edge 10-90 %% photons %.2f mm, model %.2f mm, RMS %.4f (top layer's standard dipole %.4f)\n",
                name, "rgb"[c], 1e3 * width, 1e3 * edge_width([&](double x) { return model.edge(x)[c]; }), off,
                edge_rms(traced, standard, c, width));
            EXPECT_LT(off, layers.size() == 1 && std::isinf(layers[0].thickness_m) ? 0.012 : 0.03) << name << c;
        }
    }
}

TEST(SolidExitance, NormalisedDiffusionIsThatOfASolidWithoutABoundary) {
    SolidLayer open = jensen_skin1();
    open.eta = 1.0;
    for (int c = 0; c < 3; ++c) {
        PhotonCount traced = PhotonTrace({&open, 1}, c, 9).run(20000);
        const vec3 path = 1.0f / vec3(open.sigma_s_reduced + open.sigma_a), albedo(float(traced.reflected));
        const RadialProfile model([&](double r) { return dvec3(normalised_diffusion(albedo, path, float(r))); });
        const double width = edge_width([&](double x) { return model.edge(x)[c]; });
        std::printf("index 1, %c: edge 10-90 %% photons %.2f mm, normalised diffusion %.2f mm\n", "rgb"[c],
                    1e3 * traced.edge_width(), 1e3 * width);
        EXPECT_NEAR(width, traced.edge_width(), 0.12 * width) << c;
    }
}

void against_photons_through(const char* name, const SolidProfile& skin) {
    const SlabTransmittance table(skin.layers);
    EXPECT_NEAR(table.at(0.0f).x, 1.0f, 1e-4f);
    EXPECT_EQ(table.at(2.0f * table.reach_m()), vec3(0.0f));
    for (const double mm : {1.0, 2.0, 3.0, 5.0, 8.0})
        for (int c = 0; c < 3; ++c) {
            const double thickness = mm * 1e-3;
            const Layers layers = slab_of(skin.layers, thickness);
            const double traced = PhotonTrace(layers, c, 6).run(8000).transmitted;
            const double found = double(table.at(float(thickness))[c]);
            const double alone = double(skin.fit.profile.through(float(thickness))[c]);
            std::printf("%s, %.0f mm %c: photons %.4f, table %.4f, e^(-s^2/v) %.4f (%+.0f %%)\n", name, mm, "rgb"[c],
                        traced, found, alone, 100.0 * (alone / std::max(traced, 1e-9) - 1.0));
            EXPECT_NEAR(found, layered_response(layers, 0.0).transmitted[c], 2e-3) << mm;
            EXPECT_NEAR(found, traced, 0.03 + 0.05 * traced) << mm;
        }
}

TEST(SlabTransmittance, IsThatOfPhotonsWhereTheProfileAloneIsNot) {
    against_photons_through("skin1", solid_profile({jensen_skin1()}));
    against_photons_through("three layers", solid_profile(three_layer_skin()));
}

TEST(SlabTransmittance, CoversBothSides) {
    const Layers skin = three_layer_skin(), thick = slab_of(skin, 3e-3), thin = slab_of(skin, 0.45e-3);
    ASSERT_EQ(thick.size(), 5u);
    EXPECT_DOUBLE_EQ(thick[0].thickness_m, 0.25e-3);
    EXPECT_EQ(thick[0], thick[4]);
    EXPECT_NEAR(thick[2].thickness_m, 2.1e-3, 1e-9);
    EXPECT_NEAR(thin[0].thickness_m, 0.125e-3, 1e-9) << "half of everything";
    EXPECT_EQ(thin[2].thickness_m, 0.0);
}

}  // namespace
}  // namespace tyndall::physics
