#pragma once
// Small scenes made by hand, for the renderer's tests.

#include <cmath>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>

#include "scene/render_scene.h"

namespace tyndall::test {

inline uint64_t next_id() {
    static uint64_t id = 1000;
    return ++id;
}

inline std::shared_ptr<const MeshAsset> asset_of(Mesh mesh, const char* name) {
    mesh.bounds = bounds_of(mesh.positions);
    auto asset = std::make_shared<MeshAsset>();
    asset->id = next_id();
    asset->name = name;
    asset->mesh = std::move(mesh);
    return asset;
}

/// A rows x columns grid of vertices bent by `place`, which gives position and normal at (u, v) in [0, 1].
inline Mesh grid(int rows, int columns, const std::function<void(float, float, glm::vec3&, glm::vec3&)>& place) {
    Mesh mesh;
    for (int y = 0; y <= rows; ++y)
        for (int x = 0; x <= columns; ++x) {
            const float u = float(x) / float(columns);
            const float v = float(y) / float(rows);
            glm::vec3 position;
            glm::vec3 normal;
            place(u, v, position, normal);
            mesh.positions.push_back(position);
            mesh.normals.push_back(normal);
            mesh.tangents.emplace_back(1, 0, 0, 1);
            mesh.uv0.emplace_back(u, v);
        }
    const auto at = [columns](int x, int y) { return uint32_t(y * (columns + 1) + x); };
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x)
            for (const uint32_t i :
                 {at(x, y), at(x, y + 1), at(x + 1, y), at(x + 1, y), at(x, y + 1), at(x + 1, y + 1)})
                mesh.indices.push_back(i);
    return mesh;
}

/// Radius 1 about the origin.
inline std::shared_ptr<const MeshAsset> sphere_mesh(int rings = 48) {
    return asset_of(
        grid(rings, 2 * rings,
             [](float u, float v, glm::vec3& position, glm::vec3& normal) {
                 const float azimuth = 6.2831853f * u;
                 const float polar = 3.1415927f * v;
                 normal = {std::sin(polar) * std::sin(azimuth), std::cos(polar), std::sin(polar) * std::cos(azimuth)};
                 position = normal;
             }),
        "sphere");
}

/// The square [-1, 1]^2 in the XZ plane, seen from +Y.
inline std::shared_ptr<const MeshAsset> plane_mesh() {
    return asset_of(grid(1, 1,
                         [](float u, float v, glm::vec3& position, glm::vec3& normal) {
                             position = {2.0f * u - 1.0f, 0.0f, 2.0f * v - 1.0f};
                             normal = {0, 1, 0};
                         }),
                    "plane");
}

inline std::shared_ptr<Material> material(glm::vec3 colour, float metallic, float roughness) {
    auto made = std::make_shared<Material>();
    made->id = next_id();
    made->base_colour = glm::vec4(colour, 1.0f);
    made->metallic = metallic;
    made->roughness = roughness;
    return made;
}

inline void add(RenderScene& scene, std::shared_ptr<const MeshAsset> mesh, std::shared_ptr<const Material> material,
                const glm::mat4& transform) {
    Surface surface;
    surface.bounds = mesh->mesh.bounds.transformed(transform);
    surface.mesh = std::move(mesh);
    surface.material = std::move(material);
    surface.transform = surface.previous_transform = transform;
    scene.surfaces.push_back(std::move(surface));
}

inline glm::mat4 translated(glm::vec3 by) {
    return glm::translate(glm::mat4(1.0f), by);
}
inline glm::mat4 scaled(glm::vec3 by) {
    return glm::scale(glm::mat4(1.0f), by);
}

/// A camera or light at `from` that looks at `to`.
inline glm::mat4 looking(glm::vec3 from, glm::vec3 to, glm::vec3 up = {0, 1, 0}) {
    return glm::inverse(glm::lookAt(from, to, up));
}

inline Light directional(glm::vec3 travel, glm::vec3 lux) {
    Light light;
    light.kind = LightKind::directional;
    light.transform = looking({0, 0, 0}, travel, std::abs(travel.y) > 0.9f ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0));
    light.intensity = lux;
    return light;
}

inline Light point(glm::vec3 at, glm::vec3 candela) {
    Light light;
    light.transform = translated(at);
    light.intensity = candela;
    return light;
}

inline Light spot(glm::vec3 from, glm::vec3 to, glm::vec3 candela, float inner, float outer) {
    Light light;
    light.kind = LightKind::spot;
    light.transform =
        looking(from, to, std::abs(glm::normalize(to - from).y) > 0.9f ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0));
    light.intensity = candela;
    light.inner_angle = inner;
    light.outer_angle = outer;
    return light;
}

/// An equirectangular image, radiance by `colour(direction)`.
inline std::shared_ptr<const TextureAsset> probe_image(int width, const std::function<glm::vec3(glm::vec3)>& colour) {
    auto asset = std::make_shared<TextureAsset>();
    asset->id = next_id();
    asset->name = "probe";
    asset->image = Image(width, width / 2, 3, Image::Type::f32);
    asset->filter = TextureFilter::linear;
    for (int y = 0; y < width / 2; ++y)
        for (int x = 0; x < width; ++x) {
            const float azimuth = 6.2831853f * ((float(x) + 0.5f) / float(width) - 0.5f);
            const float polar = 3.1415927f * (float(y) + 0.5f) / float(width / 2);
            const glm::vec3 direction{std::sin(polar) * std::sin(azimuth), std::cos(polar),
                                      -std::sin(polar) * std::cos(azimuth)};
            const glm::vec3 value = colour(direction);
            for (int c = 0; c < 3; ++c) asset->image.at(x, y, c) = value[c];
        }
    return asset;
}

/// Five by two spheres on a floor: roughness rises to the right, metals above; a light of each kind and a sky.
inline RenderScene spheres() {
    RenderScene scene;
    const auto sphere = sphere_mesh();
    for (int x = 0; x < 5; ++x)
        for (int y = 0; y < 2; ++y) {
            const glm::vec3 colour = y == 0 ? glm::vec3(0.5f, 0.1f, 0.08f) : glm::vec3(0.9f, 0.7f, 0.35f);
            add(scene, sphere, material(colour, float(y), 0.05f + 0.2375f * float(x)),
                translated({1.1f * float(x - 2), 0.5f + 1.1f * float(y), 0}) * scaled(glm::vec3(0.5f)));
        }
    add(scene, plane_mesh(), material(glm::vec3(0.4f), 0.0f, 0.6f), scaled({6, 1, 6}));
    scene.lights = {directional(glm::normalize(glm::vec3(-0.5f, -1, -0.6f)), glm::vec3(800, 760, 700)),
                    point({-2, 1.5f, 1.5f}, {60, 120, 400}),
                    spot({2.5f, 3, 2.5f}, {1, 0.5f, 0}, {1800, 900, 300}, 0.25f, 0.4f)};
    for (Light& light : scene.lights) light.shadow.enabled = true;
    scene.sky.radiance = glm::vec3(60.0f);
    scene.sky.image = probe_image(256, [](glm::vec3 d) {
        return d.y > 0 ? glm::mix(glm::vec3(0.9f, 0.95f, 1), glm::vec3(0.25f, 0.45f, 0.9f), d.y)
                       : glm::vec3(0.22f, 0.2f, 0.18f);
    });
    scene.camera.transform = looking({0, 2.2f, 5.2f}, {0, 0.9f, 0});
    scene.camera.vertical_fov = 0.75f;
    scene.camera.ev100 = 7.0f;
    return scene;
}

}  // namespace tyndall::test
