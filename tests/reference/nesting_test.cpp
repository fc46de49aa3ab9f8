// Interiors inside interiors: where they overlap, the one of higher priority is there alone.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "scenes.h"

namespace tyndall::reference {
namespace {

using glm::dvec3;
using glm::vec3;

constexpr double kLimit = 0.01;
constexpr double kMirrored = 0.02;  ///< of the few paths that come back
constexpr float kGlass = 1.5f, kLiquid = 1.33f;
const vec3 kGlassAbsorbs(0.1f, 0.05f, 0.2f), kLiquidAbsorbs(0.2f, 0.6f, 1.1f);

Surface slab(float low, float high, float eta, const vec3& sigma_a, int priority, const vec3& sigma_s = vec3(0.0f)) {
    Surface surface = shape(Primitive::box, between({-50.0f, -50.0f, low}, {50.0f, 50.0f, high}));
    ScatteringInterior interior;
    interior.sigma_a_per_m = sigma_a, interior.sigma_s_per_m = sigma_s;
    interior.eta = eta, interior.priority = priority;
    surface.interior = interior;
    return surface;
}

/// Liquid from z = 1 to 2 between walls of glass that end at 0 and 3; the liquid's mesh reaches `overlap` into both.
RenderScene tank(float overlap, float angle_deg, const vec3& scattering = vec3(0.0f)) {
    const float angle = glm::radians(angle_deg);
    RenderScene scene;
    scene.camera = camera_at(vec3(0.0f, 0.0f, 3.0f) + 2.0f * vec3(std::sin(angle), 0.0f, std::cos(angle)),
                             vec3(0.0f, 0.0f, 3.0f), 1e-3f);
    scene.surfaces.push_back(slab(1.0f - overlap, 2.0f + overlap, kLiquid, kLiquidAbsorbs, 1, scattering));
    scene.surfaces.push_back(slab(0.0f, 1.0f, kGlass, kGlassAbsorbs, 2));
    scene.surfaces.push_back(slab(2.0f, 3.0f, kGlass, kGlassAbsorbs, 2));
    return scene;
}

double fresnel(double cosine, double eta) {
    const double beyond = std::sqrt(1.0 - (1.0 - cosine * cosine) / (eta * eta));
    const double s = (cosine - eta * beyond) / (cosine + eta * beyond),
                 p = (eta * cosine - beyond) / (eta * cosine + beyond);
    return 0.5 * (s * s + p * p);
}

/// Transmittance and reflectances of a stack, from either side.
struct Stack {
    dvec3 through{1.0}, front{0.0}, back{0.0};
    /// Puts another behind it: the light that goes to and fro between them is a geometric series.
    void add(const dvec3& t, double r) {
        const dvec3 loop = 1.0 - back * r;
        front += through * through * r / loop;
        back = r + t * t * back / loop;
        through = through * t / loop;
    }
    void absorb(const dvec3& t) { through *= t, back *= t * t; }
};

/// Glass, liquid and glass, each 1 m thick, by Fresnel's equations for unpolarised light and Beer and Lambert's law.
Stack closed_form(float angle_deg) {
    const double sine = std::sin(glm::radians(static_cast<double>(angle_deg)));
    const double index[] = {1.0, static_cast<double>(kGlass), static_cast<double>(kLiquid), static_cast<double>(kGlass),
                            1.0};
    const dvec3 absorbs[] = {dvec3(0.0), dvec3(kGlassAbsorbs), dvec3(kLiquidAbsorbs), dvec3(kGlassAbsorbs)};
    Stack stack;
    for (size_t i = 0; i < 4; ++i) {
        const double cosine = std::sqrt(1.0 - std::pow(sine / index[i], 2.0));
        stack.absorb(glm::exp(-absorbs[i] / cosine));
        const double r = fresnel(cosine, index[i + 1] / index[i]);
        stack.add(dvec3(1.0 - r), r);
    }
    return stack;
}

TEST(Nesting, OverlappingMeshesAreTouchingOnes) {
    for (const float angle : {0.0f, 50.0f})
        for (const float overlap : {0.05f, 0.6f}) {
            RenderScene scene = tank(overlap, angle);
            const Stack truth = closed_form(angle);
            scene.sky.radiance = vec3(1.0f);
            const std::string what = fmt::format("tank at {} degrees, overlapping by {} m", angle, overlap);
            expect_near(what + ", both sides lit", measure(scene, square_picture(16, 1024), 1024),
                        truth.through + truth.front, kLimit);
            // a black wall behind it leaves what comes through out: the rest is mirrored
            Material black = white_diffuse();
            black.base_colour = glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
            scene.surfaces.push_back(
                shape(Primitive::box, between({-80.0f, -80.0f, -2.0f}, {80.0f, 80.0f, -1.0f}), black));
            expect_near(what + ", lit in front", measure(scene, square_picture(16, 2048), 2048), truth.front,
                        kMirrored);
        }
}

TEST(Nesting, ScatteringLiquidKeepsItsWalls) {
    // Scattering liquid: no closed form, but how far its mesh reaches into the glass must not matter.
    Measured found[2];
    for (size_t i = 0; i < 2; ++i) {
        RenderScene scene = tank(i == 0 ? 0.05f : 0.6f, 30.0f, {0.5f, 1.0f, 2.0f});
        scene.sky.radiance = vec3(1.0f);
        TraceSettings settings = square_picture(16, 512);
        settings.seed = static_cast<uint32_t>(i);
        found[i] = measure(scene, settings, 512);
    }
    for (int c = 0; c < 3; ++c) {
        const double error = std::hypot(found[0].error[c], found[1].error[c]);
        const double z = (found[0].mean[c] - found[1].mean[c]) / error;
        fmt::print("scattering liquid, channel {}: {:.5f} and {:.5f}, z {:+.2f} (limit 3.5)\n", c, found[0].mean[c],
                   found[1].mean[c], z);
        EXPECT_LT(std::abs(z), 3.5);
        EXPECT_LT(3.0 * error / found[0].mean[c], 0.02) << "too few samples to tell";
    }
}

}  // namespace
}  // namespace tyndall::reference
