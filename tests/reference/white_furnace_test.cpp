// Whatever is convex and takes no light away cannot be told from a uniform field of light that it stands in.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "physics/physics.h"
#include "scenes.h"

namespace tyndall::reference {
namespace {

using glm::vec3;

constexpr double kFurnace = 0.001;
constexpr double kLayer = 0.003;  ///< of light that a bright lobe sends from few directions: there is more noise
constexpr double kColour = 0.01;  ///< of media that differ between channels, and share their flights
constexpr double kDielectric = 0.002;
const glm::mat4 kUnit = between(vec3(-1.0f), vec3(1.0f));

/// The shape fills the picture: nothing but it is measured. `wide` also sees its rim.
RenderScene before(Surface surface, bool wide = false) {
    RenderScene scene = uniform_field(camera_at({2.0f, 3.0f, 4.0f}, vec3(0.0f), wide ? 19.0f : 14.0f));
    scene.surfaces.push_back(std::move(surface));
    return scene;
}

void expect_white(const std::string& what, const RenderScene& scene, int64_t samples, double limit = kFurnace) {
    expect_near(what, measure(scene, square_picture(16, samples), samples), glm::dvec3(1.0), limit);
}

TEST(WhiteFurnace, DiffuseSphereAndBox) {
    expect_white("diffuse sphere", before(shape(Primitive::sphere, kUnit), true), 1024);
    expect_white("diffuse box", before(shape(Primitive::box, kUnit)), 1024);
}

TEST(WhiteFurnace, StandardMaterialsLayer) {
    // Kulla & Conty's form adds up to exactly 1 where the base is white, or the metal is: at every angle, which
    // Layers.WhiteOnesReturnAllLight shows without noise.
    for (const float metallic : {0.0f, 1.0f})
        for (const float roughness : {0.2f, 0.7f}) {
            Material material;
            material.metallic = metallic;
            material.roughness = roughness;
            const char* kind = metallic > 0.5f ? "metal" : "coated";
            expect_white(fmt::format("{} sphere, roughness {}", kind, roughness),
                         before(shape(Primitive::sphere, kUnit, material), true), 512, kLayer);
        }
}

TEST(WhiteFurnace, Leaves) {
    // What goes through one wall of a box lights the others from inside, and all of it comes out.
    for (const float share : {0.3f, 1.0f}) {
        Material material = white_diffuse();
        material.diffuse_transmission = share;
        material.double_sided = true;
        expect_white(fmt::format("sheet, {} through", share), before(shape(Primitive::plane, kUnit, material)), 256);
        expect_white(fmt::format("box, {} through", share), before(shape(Primitive::box, kUnit, material)), 1024,
                     kLayer);
        material.specular = 1.0f;
        material.roughness = 0.5f;
        expect_white(fmt::format("coated sheet, {} through", share), before(shape(Primitive::plane, kUnit, material)),
                     512, kLayer);
    }
}

TEST(Leaves, LitFromBehind) {
    // E cos(l) t colour / pi: nothing else is in the scene.
    constexpr float kLux = 3.0f, kShare = 0.6f;
    const vec3 colour(0.9f, 0.5f, 0.2f);
    Material material = white_diffuse();
    material.base_colour = glm::vec4(0.3f, 0.6f, 0.1f, 1.0f);
    material.diffuse_transmission = kShare;
    material.diffuse_transmission_colour = colour;
    material.double_sided = true;
    for (const float side : {-1.0f, 1.0f}) {
        RenderScene scene;
        scene.camera = camera_at({0.4f, 3.0f, 0.2f}, vec3(0.0f), 8.0f);
        scene.surfaces.push_back(shape(Primitive::plane, kUnit, material));
        Light sun;
        sun.kind = LightKind::directional;
        sun.intensity = vec3(kLux);
        const glm::vec3 from(1.0f, 2.0f * side, 0.5f);
        sun.transform = glm::inverse(glm::lookAt(from, vec3(0.0f), vec3(0.0f, 0.0f, 1.0f)));
        scene.lights.push_back(sun);
        const float cosine = std::abs(from.y) / glm::length(from);
        const vec3 albedo = side < 0.0f ? kShare * colour : (1.0f - kShare) * vec3(material.base_colour);
        expect_near(side < 0.0f ? "leaf lit from behind" : "leaf lit from the front",
                    measure(scene, square_picture(8, 64), 64), glm::dvec3(albedo * kLux * cosine / physics::kPi), 1e-4);
    }
}

RenderScene medium_box(Medium medium) {
    RenderScene scene = uniform_field(camera_at({2.0f, 3.0f, 4.0f}, vec3(0.0f), 14.0f));
    medium.transform = kUnit;
    scene.media.push_back(std::move(medium));
    return scene;
}

TEST(WhiteFurnace, MediumInABox) {
    Medium medium;
    medium.sigma_s_per_m = vec3(0.5f);
    expect_white("even medium", medium_box(medium), 2048);
    medium.phase = henyey_greenstein(0.6f);
    medium.density = BlobDensity{{{vec3(0.0f), 0.2f, 1.0f}, {vec3(0.2f, 0.1f, 0.3f), 0.1f, 2.0f}}};
    expect_white("blobs, g 0.6", medium_box(medium), 2048);
    medium.sigma_s_per_m = {1.0f, 2.0f, 4.0f};
    expect_white("coloured and dense blobs, g 0.6", medium_box(medium), 512, kColour);
}

Surface filled(Primitive primitive, float eta, float roughness, const vec3& sigma_s) {
    Surface surface = shape(primitive, kUnit);
    ScatteringInterior interior;
    interior.sigma_s_per_m = sigma_s;
    interior.eta = eta;
    interior.roughness = roughness;
    interior.phase = henyey_greenstein(0.3f);
    surface.interior = interior;
    return surface;
}

TEST(WhiteFurnace, ScatteringInterior) {
    // Behind a smooth boundary every path ends in the field, and brings what it can: there is no noise.
    expect_white("smooth sphere, eta 1.3", before(filled(Primitive::sphere, 1.3f, 0.0f, vec3(2.0f)), true), 64);
    expect_white("smooth box, eta 1.5", before(filled(Primitive::box, 1.5f, 0.0f, vec3(2.0f))), 64);
    expect_white("matched sphere", before(filled(Primitive::sphere, 1.0f, 0.0f, vec3(0.5f)), true), 2048);
    const vec3 coloured(1.0f, 2.0f, 3.0f);
    expect_white("coloured matched sphere", before(filled(Primitive::sphere, 1.0f, 0.0f, coloured), true), 256,
                 kColour);
    expect_white("coloured smooth box, eta 1.5", before(filled(Primitive::box, 1.5f, 0.0f, coloured)), 256, kColour);
    expect_white("coloured rough box, eta 1.3", before(filled(Primitive::box, 1.3f, 0.3f, coloured)), 512, kColour);
}

TEST(WhiteFurnace, PaintedInterior) {
    for (const float eta : {1.0f, 1.3f}) {
        Material material = white_diffuse();
        material.paint_cover = 0.5f;
        material.roughness = 0.5f;
        material.specular = eta > 1.0f ? 1.0f : 0.0f;
        material.ior = eta;
        Surface painted = shape(Primitive::sphere, kUnit, material);
        painted.interior = filled(Primitive::sphere, eta, material.roughness, vec3(0.5f)).interior;
        expect_white(fmt::format("painted sphere, eta {}", eta), before(painted, true), 512, kLayer);
    }
}

TEST(DielectricEnergy, ClearInteriorsLoseNothing) {
    for (const float eta : {1.1f, 1.33f, 1.5f, 2.0f})
        for (const Primitive primitive : {Primitive::box, Primitive::sphere})
            expect_white(fmt::format("clear {}, eta {}", primitive == Primitive::box ? "box" : "sphere", eta),
                         before(filled(primitive, eta, 0.0f, vec3(0.0f))), 32, kDielectric);
    for (const float eta : {1.33f, 1.5f})
        expect_white(fmt::format("clear box, eta {}, roughness 0.2", eta),
                     before(filled(Primitive::box, eta, 0.2f, vec3(0.0f))), 1024, kDielectric);
    // Rougher: most of the noise is of looking for the field, which walks between microfacets meet rarely
    // (Samplers.RoughBoundary shows that these lose nothing).
    expect_white("clear sphere, eta 1.5, roughness 0.5",
                 before(filled(Primitive::sphere, 1.5f, 0.5f, vec3(0.0f)), true), 1024, kColour);
}

}  // namespace
}  // namespace tyndall::reference
