#include "scenes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <map>

#include "scene/primitives.h"

namespace tyndall::reference {
namespace {

std::shared_ptr<const MeshAsset> mesh_of(Primitive primitive) {
    static std::map<Primitive, std::shared_ptr<const MeshAsset>> made;
    std::shared_ptr<const MeshAsset>& mesh = made[primitive];
    if (!mesh) mesh = std::make_shared<MeshAsset>(MeshAsset{new_asset_id(), "", make_primitive(primitive, 512)});
    return mesh;
}

glm::dvec3 mean_of(const Image& image) {
    glm::dvec3 sum(0.0);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < 3; ++c) sum[c] += static_cast<double>(image.at(x, y, c));
    return sum / (static_cast<double>(image.width) * image.height);
}

}  // namespace

Measured mean_of(const Film& film) {
    const double pixels = static_cast<double>(film.size().x) * film.size().y;
    return {mean_of(film.radiance()), glm::sqrt(mean_of(film.variance()) / pixels)};
}

Measured mean_of(const Film& film, Component component) {
    return {mean_of(film.component(component)), mean_of(film).error};
}

Measured measure(const RenderScene& scene, const TraceSettings& settings, int64_t samples) {
    return mean_of(trace(scene, settings, samples));
}

TraceSettings square_picture(int pixels, int64_t samples) {
    TraceSettings settings;
    settings.size = {pixels, pixels};
    settings.batch = 1;
    while (settings.batch < 256 && settings.batch * 8 <= samples) settings.batch *= 2;
    return settings;
}

void expect_near(const std::string& what, const Measured& measured, const glm::dvec3& truth, double limit) {
    const glm::dvec3 off = measured.mean / truth - 1.0, noise = measured.error / glm::abs(truth);
    fmt::print("{}: {:.5f} {:.5f} {:.5f}, off by {:+.4f} {:+.4f} {:+.4f} % (limit {:.3g} %; noise {:.4f} %)\n", what,
               measured.mean.x, measured.mean.y, measured.mean.z, 100.0 * off.x, 100.0 * off.y, 100.0 * off.z,
               100.0 * limit, 100.0 * std::max({noise.x, noise.y, noise.z}));
    for (int c = 0; c < 3; ++c) {
        EXPECT_LT(std::abs(off[c]), limit) << what << ", channel " << c;
        EXPECT_LT(3.0 * noise[c], limit) << what << ": too few samples to tell";
    }
}

void expect_below(const std::string& what, double measured, double limit) {
    fmt::print("{}: {:.3g} (limit {:.3g})\n", what, measured, limit);
    EXPECT_LT(measured, limit) << what;
}

Material white_diffuse() {
    Material material;
    material.specular = 0.0f;
    return material;
}

Surface shape(Primitive primitive, const glm::mat4& transform, const Material& material) {
    Surface surface;
    surface.mesh = mesh_of(primitive);
    surface.material = std::make_shared<const Material>(material);
    surface.transform = transform;
    return surface;
}

glm::mat4 between(const glm::vec3& low, const glm::vec3& high) {
    return glm::scale(glm::translate(glm::mat4(1.0f), 0.5f * (low + high)), high - low);
}

Camera camera_at(const glm::vec3& eye, const glm::vec3& target, float fov_deg) {
    const glm::vec3 forward = glm::normalize(target - eye);
    const glm::vec3 up = std::abs(forward.y) > 0.99f ? glm::vec3(0.0f, 0.0f, -1.0f) : glm::vec3(0.0f, 1.0f, 0.0f);
    Camera camera;
    camera.transform = glm::inverse(glm::lookAt(eye, target, up));
    camera.vertical_fov = glm::radians(fov_deg);
    camera.exposure = 1.0f;
    return camera;
}

RenderScene uniform_field(const Camera& camera) {
    RenderScene scene;
    scene.camera = camera;
    scene.sky.radiance = glm::vec3(1.0f);
    return scene;
}

PhaseFunction henyey_greenstein(float g) {
    PhaseFunction phase;
    phase.kind = PhaseKind::henyey_greenstein;
    phase.parameters.x = g;
    return phase;
}

}  // namespace tyndall::reference
