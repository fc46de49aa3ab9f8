// Light that comes straight through media, against Beer and Lambert's law.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "scenes.h"

namespace tyndall::reference {
namespace {

using glm::dvec3;
using glm::vec3;

constexpr double kExact = 1e-5;       ///< even media are computed in closed form
constexpr double kEstimated = 0.005;  ///< of light that came through; its noise has to be below
constexpr double kFlights = 0.015;    ///< of paths, of which most end in the medium
constexpr int64_t kFlightSamples = 1024;

const vec3 kScattering(0.3f, 0.1f, 0.2f), kAbsorption(0.1f, 0.6f, 0.05f);
const vec3 kEye(0.4f, 0.5f, 5.0f);
const glm::mat4 kBox = between(vec3(-1.0f, -1.0f, -2.0f), vec3(1.0f, 1.0f, 2.0f));

RenderScene through(const DensityField& density) {
    RenderScene scene = uniform_field(camera_at(kEye, vec3(-0.2f, -0.3f, -3.0f), 1e-3f));
    Medium medium;
    medium.transform = kBox;
    medium.sigma_s_per_m = kScattering;
    medium.sigma_a_per_m = kAbsorption;
    medium.density = density;
    scene.media.push_back(medium);
    return scene;
}

/// Simpson's rule over the ray that the camera looks along, of a density of the place in the box [-1/2, 1/2]^3.
template <class Density>
dvec3 expected(Density density) {
    constexpr int kSteps = 20000;
    const dvec3 eye(kEye), direction = glm::normalize(dvec3(-0.2, -0.3, -3.0) - eye);
    const dvec3 scale(0.5, 0.5, 0.25);
    double low = 0.0, high = 1e9;
    for (int a = 0; a < 3; ++a) {
        const double one = (-0.5 / scale[a] - eye[a]) / direction[a], other = (0.5 / scale[a] - eye[a]) / direction[a];
        low = std::max(low, std::min(one, other)), high = std::min(high, std::max(one, other));
    }
    double sum = 0.0;
    for (int i = 0; i <= kSteps; ++i) {
        const double weight = i == 0 || i == kSteps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
        sum += weight * density((eye + direction * (low + (high - low) * i / kSteps)) * scale);
    }
    return glm::exp(-dvec3(kScattering + kAbsorption) * (sum * (high - low) / kSteps / 3.0));
}

/// By shadow-ray tracking (no order but 0 is wanted), and by flights of paths that also scatter.
void expect_transmittance(const std::string& what, const DensityField& density, const dvec3& truth, double limit,
                          int64_t samples) {
    const RenderScene scene = through(density);
    TraceSettings settings = square_picture(16, samples);
    settings.max_order = 0;
    expect_near(what + ", by tracking", measure(scene, settings, samples), truth, limit);
    settings.max_order = std::numeric_limits<int>::max();
    settings.components = true;
    settings.batch = 128;
    const Film film = trace(scene, settings, kFlightSamples);
    expect_near(what + ", by flights", mean_of(film, Component::emission), truth, kFlights);
}

TEST(BeerLambert, EvenSlab) {
    expect_transmittance("even slab", ConstantDensity{}, expected([](const dvec3&) { return 1.0; }), kExact, 128);
}

TEST(BeerLambert, AbsorbingSlabOfADielectric) {
    // At normal incidence on a matched slab, and on one of glass: the inter-reflections of both faces are summed.
    for (const float eta : {1.0f, 1.5f}) {
        RenderScene scene = uniform_field(camera_at({0.0f, 0.0f, 5.0f}, vec3(0.0f), 1e-3f));
        scene.surfaces.push_back(shape(Primitive::box, between({-9.0f, -9.0f, -1.0f}, {9.0f, 9.0f, 0.0f})));
        ScatteringInterior interior;
        interior.sigma_a_per_m = {0.2f, 0.7f, 1.5f};
        interior.eta = eta;
        scene.surfaces.back().interior = interior;
        const double e = static_cast<double>(eta), r = std::pow((e - 1.0) / (e + 1.0), 2.0);
        const dvec3 t = glm::exp(-dvec3(interior.sigma_a_per_m)), loop = 1.0 - r * r * t * t;
        const dvec3 truth = (1.0 - r) * (1.0 - r) * t / loop + r + (1.0 - r) * (1.0 - r) * r * t * t / loop;
        expect_near(eta > 1.0f ? "slab of glass" : "matched slab", measure(scene, square_picture(16, 512), 512), truth,
                    kEstimated);
    }
}

TEST(BeerLambert, Height) {
    const HeightDensity height{-1.0f, 0.7f};
    // the box is 2 m high: y in it is half the height in the world
    expect_transmittance("height", height, expected([](const dvec3& p) { return std::exp(-(2.0 * p.y + 1.0) / 0.7); }),
                         kEstimated, 512);
}

TEST(BeerLambert, Blobs) {
    const BlobDensity blobs{{{vec3(0.0f), 0.15f, 1.5f}, {vec3(0.1f, 0.1f, 0.2f), 0.05f, 4.0f}}};
    const auto density = [&](const dvec3& p) {
        double sum = 0.0;
        for (const auto& blob : blobs.blobs) {
            const dvec3 away = p - dvec3(blob.centre);
            sum += static_cast<double>(blob.weight) *
                   std::exp(-glm::dot(away, away) / (2.0 * std::pow(static_cast<double>(blob.radius), 2.0)));
        }
        return sum;
    };
    expect_transmittance("blobs", blobs, expected(density), kEstimated, 512);
}

TEST(BeerLambert, Grid) {
    constexpr int kSize = 6;
    auto asset = std::make_shared<VolumeAsset>();
    asset->volume.size = glm::ivec3(kSize);
    for (int i = 0; i < kSize * kSize * kSize; ++i)
        asset->volume.values.push_back(0.1f + 0.9f * static_cast<float>((i * 7919) % 101) / 100.0f);
    GridDensity grid{asset, glm::translate(glm::mat4(1.0f), vec3(0.5f)), 1.3f};
    const auto density = [&](const dvec3& p) {  // trilinear; even beyond the outermost centres
        const dvec3 at = (p + 0.5) * static_cast<double>(kSize) - 0.5;
        double sum = 0.0;
        for (int corner = 0; corner < 8; ++corner) {
            glm::ivec3 cell = glm::ivec3(glm::floor(at)) + glm::ivec3(corner & 1, (corner >> 1) & 1, corner >> 2);
            const dvec3 weight = 1.0 - glm::abs(at - dvec3(cell));
            cell = glm::clamp(cell, 0, kSize - 1);
            sum += weight.x * weight.y * weight.z * static_cast<double>(asset->volume.at(cell.x, cell.y, cell.z));
        }
        return 1.3 * sum;
    };
    expect_transmittance("grid", grid, expected(density), kEstimated, 512);
}

}  // namespace
}  // namespace tyndall::reference
