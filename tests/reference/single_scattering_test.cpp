// Light that a medium scatters once, against numeric quadrature and against Sun's closed form.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "physics/physics.h"
#include "scenes.h"

namespace tyndall::reference {
namespace {

using glm::dvec3;
using glm::vec3;

constexpr double kLimit = 0.003;

const dvec3 kScattering(0.2, 0.35, 0.1), kAbsorption(0.05, 0.1, 0.4);
constexpr float kG = 0.6f;
const vec3 kHalf(1.5f, 1.0f, 2.0f);  ///< the box of fog, about the origin

struct View {
    vec3 eye, target;
};
const View kViews[] = {{{0.1f, 0.2f, 5.0f}, {0.0f, -0.1f, 0.0f}}, {{0.5f, -0.4f, 1.2f}, {-1.0f, 0.6f, -2.0f}}};

/// Distances between which a ray is in the box; from the place itself on when it starts inside.
void clip(const dvec3& origin, const dvec3& direction, double& low, double& high) {
    low = 0.0;
    for (int a = 0; a < 3; ++a) {
        const double h = static_cast<double>(kHalf[a]);
        const double one = (-h - origin[a]) / direction[a], other = (h - origin[a]) / direction[a];
        low = std::max(low, std::min(one, other)), high = std::min(high, std::max(one, other));
    }
}

/// What arrives at a place from a lamp without size: irradiance facing it, and the direction and way to it.
dvec3 arriving(const Light& light, const dvec3& place, dvec3& to_light, double& metres) {
    const dvec3 axis = -dvec3(light.transform[2]);
    to_light = -axis, metres = 1e6;
    if (light.kind == LightKind::directional) return dvec3(light.intensity);
    const dvec3 offset = dvec3(light.transform[3]) - place;
    metres = glm::length(offset), to_light = offset / metres;
    double share = 1.0;
    if (light.kind == LightKind::spot) {
        const double inner = std::cos(static_cast<double>(light.inner_angle)),
                     outer = std::cos(static_cast<double>(light.outer_angle));
        const double x = std::clamp((glm::dot(axis, -to_light) - outer) / (inner - outer), 0.0, 1.0);
        share = x * x;
    }
    return dvec3(light.intensity) * share / (metres * metres);
}

dvec3 quadrature(const View& view, const Light& light) {
    constexpr int kSteps = 100000;
    const dvec3 sigma_t = kScattering + kAbsorption, eye(view.eye),
                direction = glm::normalize(dvec3(view.target) - eye);
    double low = 0.0, high = 1e9;
    clip(eye, direction, low, high);
    dvec3 sum(0.0);
    const double step = (high - low) / kSteps, g = static_cast<double>(kG);
    for (int i = 0; i < kSteps; ++i) {  // midpoints: the spot's cone has edges
        const double t = low + step * (i + 0.5);
        const dvec3 place = eye + direction * t;
        dvec3 to_light;
        double metres = 0.0, near = 0.0;
        const dvec3 irradiance = arriving(light, place, to_light, metres);
        double way = metres;
        clip(place, to_light, near, way);
        const double u = glm::dot(to_light, direction);
        const double phase = (1.0 - g * g) / (4.0 * glm::pi<double>() * std::pow(1.0 + g * g - 2.0 * g * u, 1.5));
        sum += irradiance * phase * glm::exp(-sigma_t * (t - low + way));
    }
    return sum * kScattering * step;
}

class SingleScattering : public testing::TestWithParam<LightKind> {};

TEST_P(SingleScattering, IsTheIntegralAlongTheRay) {
    Light light;
    light.kind = GetParam();
    light.intensity = {3.0f, 2.0f, 1.0f};
    light.transform =
        camera_at({0.6f, light.kind == LightKind::point ? 0.7f : 3.0f, -0.4f}, vec3(0.0f, -1.0f, 0.1f), 1.0f).transform;
    light.inner_angle = 0.15f, light.outer_angle = 0.45f;
    for (const View& view : kViews) {
        RenderScene scene;
        scene.camera = camera_at(view.eye, view.target, 1e-3f);
        scene.lights.push_back(light);
        Medium medium;
        medium.transform = between(-kHalf, kHalf);
        medium.sigma_s_per_m = vec3(kScattering), medium.sigma_a_per_m = vec3(kAbsorption);
        medium.phase = henyey_greenstein(kG);
        scene.media.push_back(medium);
        TraceSettings settings = square_picture(16, 512);
        settings.max_order = 1;
        expect_near(view.eye.z > kHalf.z ? "seen from outside" : "seen from inside", measure(scene, settings, 512),
                    quadrature(view, light), kLimit);
        if (GetParam() == LightKind::directional) continue;  // a second way: the light as a sphere too small to matter
        scene.lights.back().source_radius_m = 0.0005f;
        expect_near("the lamp with size", measure(scene, settings, 512), quadrature(view, light), kLimit);
    }
}

INSTANTIATE_TEST_SUITE_P(All, SingleScattering,
                         testing::Values(LightKind::point, LightKind::spot, LightKind::directional),
                         [](const auto& info) {
                             return info.param == LightKind::point  ? "point"
                                    : info.param == LightKind::spot ? "spot"
                                                                    : "directional";
                         });

TEST(SingleScatteringAirLight, IsSunsClosedForm) {
    // Fog without end: nothing comes from 200 optical depths away, where the box of it ends.
    constexpr float kBeta = 0.5f, kIntensity = 7.0f, kFar = 400.0f;
    for (const float angle_deg : {20.0f, 70.0f, 130.0f}) {
        const float angle = glm::radians(angle_deg);
        RenderScene scene;
        scene.camera = camera_at(vec3(0.0f), vec3(0.0f, 0.0f, -1.0f), 1e-3f);
        Light light;
        light.intensity = vec3(kIntensity);
        light.transform[3] = glm::vec4(2.0f * std::sin(angle), 0.0f, -2.0f * std::cos(angle), 1.0f);
        scene.lights.push_back(light);
        Medium medium;
        medium.transform = between(vec3(-kFar), vec3(kFar));
        medium.sigma_s_per_m = vec3(kBeta);
        scene.media.push_back(medium);
        TraceSettings settings = square_picture(16, 512);
        settings.max_order = 1;
        const float sun = physics::airlight_point(kIntensity, kBeta, 2.0f, std::cos(angle), kFar);
        expect_near(fmt::format("lamp {} degrees aside", angle_deg), measure(scene, settings, 512),
                    dvec3(static_cast<double>(sun)), kLimit);
    }
}

}  // namespace
}  // namespace tyndall::reference
