// Lights: directions follow their densities, and both ways of finding a light agree on it.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "chi_square.h"
#include "physics/physics.h"
#include "reference/lights.h"
#include "scenes.h"

namespace tyndall::reference {
namespace {

using glm::dvec3;
using glm::vec3;

constexpr int kSamples = 300000;
const vec3 kPlace(0.3f, -0.2f, 0.5f);

/// A light's own axis as +z, to bin directions about it.
struct Frame {
    vec3 x, y, z;
    explicit Frame(const vec3& axis) : z(axis) { physics::orthonormal_basis(z, x, y); }
    [[nodiscard]] vec3 to(const vec3& d) const { return {glm::dot(d, x), glm::dot(d, y), glm::dot(d, z)}; }
    [[nodiscard]] vec3 from(const vec3& d) const { return x * d.x + y * d.y + z * d.z; }
};

/// What a scene's only light is sampled as.
struct OneLight {
    Geometry geometry;
    Lights lights;
    explicit OneLight(const RenderScene& scene)
        : geometry(scene.surfaces, std::vector<RayMask>(scene.surfaces.size(), RayMask::blocking)),
          lights(scene, geometry) {}
};

/// Samples a light into bins; samples that are dark go nowhere.
std::vector<double> sampled(const Lights& lights, const DirectionBins& bins, const Frame& frame, uint32_t seed,
                            dvec3& irradiance) {
    std::vector<double> observed(bins.count());
    irradiance = dvec3(0.0);
    Dice dice(seed);
    for (int i = 0; i < kSamples; ++i) {
        LightSample sample;
        const float x = dice();
        if (!lights.sample(0, kPlace, {x, dice()}, sample)) continue;
        irradiance += dvec3(sample.light) / static_cast<double>(kSamples);
        const size_t bin = bins.of(frame.to(sample.direction));
        if (bin < bins.count())
            ++observed[bin];
        else
            ADD_FAILURE() << "a direction away from the light";
    }
    return observed;
}

/// Density and radiance as rays that meet the light find them.
void expect_round_light(const std::string& what, const RenderScene& scene, const vec3& axis, float cosine,
                        double irradiance, uint32_t seed) {
    const OneLight one(scene);
    const DirectionBins bins{20, 20, cosine};
    const Frame frame(axis);
    dvec3 total(0.0);
    std::vector<double> expected = bins.integrals(8, [&](const vec3& local) {
        double density = 0.0;
        for (const bool missed : {false, true})
            one.lights.met({kPlace, frame.from(local)}, missed,
                           [&](size_t, const vec3& radiance, float pdf, float metres) {
                               if (std::isinf(metres) != missed) return;
                               density = static_cast<double>(pdf);
                               total += dvec3(radiance) * bins.solid_angle() / 64.0;
                           });
        return density * kSamples;
    });
    dvec3 found;
    const std::vector<double> observed = sampled(one.lights, bins, frame, seed, found);
    expect_distribution(what, expected, observed);
    EXPECT_NEAR(found.x, irradiance, 2e-3 * irradiance) << what;
    EXPECT_NEAR(total.x, irradiance, 2e-3 * irradiance) << what;
}

TEST(Samplers, RoundLights) {
    RenderScene scene;
    Light light;
    light.intensity = vec3(5.0f);
    light.source_radius_m = 0.6f;
    light.transform[3] = glm::vec4(1.0f, 1.5f, -0.5f, 1.0f);
    scene.lights.push_back(light);
    const vec3 offset = vec3(light.transform[3]) - kPlace;
    const float sine2 = 0.36f / glm::dot(offset, offset), cosine = std::sqrt(1.0f - sine2);
    // radiance I / (pi r^2) over the cone that it fills
    const double full =
        5.0 / (glm::pi<double>() * 0.36) * 2.0 * glm::pi<double>() * (1.0 - static_cast<double>(cosine));
    expect_round_light("lamp of 0.6 m", scene, glm::normalize(offset), cosine, full, 800);

    light.kind = LightKind::directional;
    light.angular_radius = 0.3f;
    light.transform = camera_at({1.0f, 2.0f, 0.5f}, vec3(0.0f), 1.0f).transform;
    scene.lights[0] = light;
    // illuminance E of a facing plane is radiance E / (pi sin^2), over a solid angle of 2 pi (1 - cos)
    const double sun = 5.0 * 2.0 * (1.0 - std::cos(0.3)) / std::pow(std::sin(0.3), 2.0);
    expect_round_light("sun of 0.3 rad", scene, vec3(light.transform[2]), std::cos(0.3f), sun, 801);
}

TEST(Samplers, GlowingTriangles) {
    RenderScene scene;
    Material glowing = white_diffuse();
    glowing.emissive = vec3(2.0f);
    const glm::mat4 placed = glm::rotate(glm::translate(glm::mat4(1.0f), vec3(0.6f, 1.4f, -0.8f)), 0.7f,
                                         glm::normalize(vec3(1.0f, 2.0f, 0.5f)));
    scene.surfaces.push_back(shape(Primitive::box, glm::scale(placed, vec3(1.0f, 0.4f, 0.7f)), glowing));
    const OneLight one(scene);
    const Frame frame(glm::normalize(vec3(placed[3]) - kPlace));
    const DirectionBins bins{20, 20, 0.75f};
    double solid_angle = 0.0;
    std::vector<double> expected = bins.integrals(48, [&](const vec3& local) {
        const Ray ray{kPlace, frame.from(local)};
        Hit hit;
        if (!one.geometry.intersect(ray, RayMask::all, hit)) return 0.0;
        solid_angle += bins.solid_angle() / (48.0 * 48.0);
        return static_cast<double>(one.lights.triangle_pdf(hit, one.geometry.point(hit), kPlace)) * kSamples;
    });
    dvec3 irradiance;
    std::vector<double> observed = sampled(one.lights, bins, frame, 802, irradiance);
    // faces that look away are dark: they are sampled, and give nothing
    double facing = 0.0, drawn = 0.0;
    for (const double value : expected) facing += value;
    for (const double value : observed) drawn += value;
    expected.push_back(kSamples - facing), observed.push_back(kSamples - drawn);
    expect_distribution("glowing box", expected, observed);
    EXPECT_NEAR(irradiance.x / (2.0 * solid_angle), 1.0, 0.005);
}

/// Dim noise, a gradient and a small sun.
std::shared_ptr<const TextureAsset> probe_image() {
    auto asset = std::make_shared<TextureAsset>();
    asset->id = new_asset_id();
    asset->image = Image(64, 32, 3, Image::Type::f32);
    Dice dice(803);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x)
            for (int c = 0; c < 3; ++c)
                asset->image.at(x, y, c) =
                    0.2f * dice() + static_cast<float>(32 - y) / 32.0f + (x == 20 && y == 9 ? 60.0f : 0.0f);
    return asset;
}

TEST(Samplers, Environment) {
    const glm::mat3 turned(glm::rotate(glm::mat4(1.0f), 0.8f, glm::normalize(vec3(1.0f, 3.0f, -1.0f))));
    const Environment environment(probe_image(), vec3(2.0f, 1.0f, 0.5f), turned);
    const DirectionBins bins{32, 32, -1.0f};
    double light = 0.0, found = 0.0;
    std::vector<double> expected = bins.integrals(24, [&](const vec3& d) {
        light += static_cast<double>(physics::luminance_rec709(environment.radiance(d))) * bins.solid_angle() / 576.0;
        return static_cast<double>(environment.pdf(d)) * kSamples;
    });
    std::vector<double> observed(bins.count());
    Dice dice(804);
    for (int i = 0; i < kSamples; ++i) {
        float pdf = 0.0f;
        const float x = dice();
        const vec3 d = environment.sample({x, dice()}, pdf);
        ++observed[bins.of(d)];
        found += static_cast<double>(physics::luminance_rec709(environment.radiance(d)) / pdf) / kSamples;
    }
    expect_distribution("light probe", expected, observed);
    EXPECT_NEAR(found / light, 1.0, 0.01);
}

TEST(Samplers, ChoiceOfALight) {
    RenderScene scene;
    scene.sky.radiance = vec3(0.4f);
    for (int i = 0; i < 5; ++i) {
        Light light;
        light.kind = i == 4 ? LightKind::directional : i == 3 ? LightKind::spot : LightKind::point;
        light.intensity = vec3(1.0f + static_cast<float>(i));
        light.source_radius_m = i == 1 ? 0.1f : 0.0f;
        light.transform = camera_at({static_cast<float>(i) - 2.0f, 1.5f, -1.0f}, kPlace, 1.0f).transform;
        scene.lights.push_back(light);
    }
    const OneLight one(scene);
    std::vector<double> expected(one.lights.count()), observed(one.lights.count());
    for (size_t i = 0; i < expected.size(); ++i)
        expected[i] = kSamples * static_cast<double>(one.lights.probability_at(i, kPlace));
    Dice dice(805);
    for (int i = 0; i < kSamples; ++i) {
        size_t chosen = 0;
        float probability = 0.0f;
        ASSERT_TRUE(one.lights.choose_at(dice(), kPlace, chosen, probability));
        ASSERT_NEAR(probability, one.lights.probability_at(chosen, kPlace), 1e-6f);
        ++observed[chosen];
    }
    expect_distribution("choice of a light", expected, observed);
}

}  // namespace
}  // namespace tyndall::reference
