#pragma once
// Translucent solids against the integral of their BSSRDF: a double loop, over pixels and the mesh's triangles.

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>

#include "app/engine.h"
#include "core/parallel.h"
#include "core/paths.h"
#include "radial_kernel.h"
#include "renderer_fixture.h"

namespace tyndall::translucency {

inline const Optics kPotato{{680, 700, 550}, {2.4f, 9.0f, 120.0f}, 1.3f};

/// Whether light comes to a place with a normal.
using Visible = std::function<bool(const glm::vec3& place, const glm::vec3& normal)>;

/// Integral over a triangle of the exitance at `at`, lit along `to_light` by 1 lux: cut until pieces are small for
/// their distance.
inline glm::dvec3 over_triangle(const std::array<glm::vec3, 3>& p, const std::array<glm::vec3, 3>& n,
                                const glm::vec3& at, const glm::vec3& to_light, double path, const Visible& visible,
                                int depth = 0) {
    const glm::vec3 middle = (p[0] + p[1] + p[2]) / 3.0f;
    const double edge =
        double(std::max({glm::distance(p[0], p[1]), glm::distance(p[1], p[2]), glm::distance(p[2], p[0])}));
    const double r = double(glm::distance(middle, at));
    if (edge > 0.3 * std::max(r, path) && depth < 6) {
        const std::array<glm::vec3, 3> q{0.5f * (p[0] + p[1]), 0.5f * (p[1] + p[2]), 0.5f * (p[2] + p[0])};
        const std::array<glm::vec3, 3> m{0.5f * (n[0] + n[1]), 0.5f * (n[1] + n[2]), 0.5f * (n[2] + n[0])};
        const auto part = [&](const std::array<glm::vec3, 3>& corners, const std::array<glm::vec3, 3>& normals) {
            return over_triangle(corners, normals, at, to_light, path, visible, depth + 1);
        };
        return part({p[0], q[0], q[2]}, {n[0], m[0], m[2]}) + part({q[0], p[1], q[1]}, {m[0], n[1], m[1]}) +
               part({q[2], q[1], p[2]}, {m[2], m[1], n[2]}) + part({q[0], q[1], q[2]}, {m[0], m[1], m[2]});
    }
    const glm::vec3 normal = glm::normalize(n[0] + n[1] + n[2]);
    const float cosine = glm::dot(normal, to_light);
    if (cosine <= 0.0f || (visible && !visible(middle, normal))) return glm::dvec3(0.0);
    const double area = 0.5 * double(glm::length(glm::cross(p[1] - p[0], p[2] - p[0])));
    Optics matched = kPotato;
    matched.eta = 1.0f;
    return area * double(cosine) * glm::dvec3(exitance(Model::better, matched, float(r)));
}

/// What a parallel light sees of a mesh: the depth of the nearest surface.
class LightDepths {
 public:
    LightDepths(const Surface& surface, const glm::vec3& to_light)
        : frame_(frame_of(to_light)), depths_(size_t(kSize * kSize), -1e30f) {
        const Mesh& mesh = surface.mesh->mesh;
        std::vector<glm::vec3> seen;
        for (const glm::vec3& p : mesh.positions)
            seen.push_back(glm::vec3(surface.transform * glm::vec4(p, 1.0f)) * frame_);
        const Bounds bounds = bounds_of(seen);
        low_ = bounds.low;
        texel_ = std::max(bounds.size().x, bounds.size().y) / float(kSize - 1);
        for (size_t t = 0; t < mesh.triangle_count(); ++t)
            draw(seen[mesh.indices[3 * t]], seen[mesh.indices[3 * t + 1]], seen[mesh.indices[3 * t + 2]]);
    }
    [[nodiscard]] bool visible(const glm::vec3& place, const glm::vec3& normal) const {
        const glm::vec3 seen = (place + 1.5f * texel_ * normal) * frame_;
        const glm::ivec2 at = glm::clamp(glm::ivec2(glm::vec2(seen - low_) / texel_ + 0.5f), 0, kSize - 1);
        return seen.z > depths_[size_t(at.y * kSize + at.x)] - 2.0f * texel_;
    }

 private:
    static constexpr int kSize = 1024;
    static glm::mat3 frame_of(const glm::vec3& toward) {
        const glm::vec3 right = glm::normalize(glm::cross(glm::vec3(0.3f, 1.0f, 0.2f), toward));
        return {right, glm::cross(toward, right), toward};
    }
    void draw(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
        const auto texel = [&](const glm::vec3& p) { return glm::vec2(p - low_) / texel_; };
        const glm::vec2 u = texel(a), v = texel(b), w = texel(c);
        const float area = (v.x - u.x) * (w.y - u.y) - (v.y - u.y) * (w.x - u.x);
        if (area == 0.0f) return;
        const glm::ivec2 first(glm::ceil(glm::min(u, glm::min(v, w)))), last(glm::max(u, glm::max(v, w)));
        for (int y = first.y; y <= last.y; ++y)
            for (int x = first.x; x <= last.x; ++x) {
                const glm::vec2 p{float(x), float(y)};
                const float s = ((p.x - u.x) * (w.y - u.y) - (p.y - u.y) * (w.x - u.x)) / area;
                const float t = ((v.x - u.x) * (p.y - u.y) - (v.y - u.y) * (p.x - u.x)) / area;
                if (s < 0.0f || t < 0.0f || s + t > 1.0f) continue;
                float& depth = depths_[size_t(y * kSize + x)];
                depth = std::max(depth, a.z + s * (b.z - a.z) + t * (c.z - a.z));
            }
    }

    glm::mat3 frame_;
    glm::vec3 low_{0.0f};
    float texel_ = 1.0f;
    std::vector<float> depths_;
};

/// How far a picture is from the double loop.
struct LoopErrors {
    size_t pixels = 0;
    glm::dvec3 mean{0.0};      ///< of the picture over the loop's
    double worst_block = 0.0;  ///< relative, of blocks that are not dark
    double relmse = 0.0;
};

/// Renders a mesh of potato of about 20 mm without refraction, as the better dipole was published.
class DoubleLoopTest : public RendererTest {
 protected:
    static constexpr int kSize = 64, kBlock = 16, kStride = 4;

    /// `mesh`: of the entity's component; `translucency`: more of the module's settings; `technique` of the interior.
    static std::string scene_text(const std::string& mesh, float scale, const std::string& translucency,
                                  const std::string& technique, const std::string& translation = "[0, 0, 0]") {
        return R"({"tyndall": 1, "modules": ["translucency"], "render": {"image": {"antialiasing": "none"},
          "translucency": {"model": "better", "scaling": "published", )" +
               translucency + R"(}}, "entities": [
          {"name": "Camera", "transform": {"translation": [0, 0, 0.06], "look_at": [0, 0, 0]},
           "camera": {"vertical_fov_deg": 24, "exposure": 1, "near_m": 0.001}},
          {"name": "Sun", "transform": {"translation": [1, 0.4, 0.2], "look_at": [0, 0, 0]},
           "directional_light": {"illuminance_lux": 1}},
          {"name": "Solid", "transform": {"scale": )" +
               std::to_string(scale) + R"(, "translation": )" + translation + R"(}, "mesh": {)" + mesh + R"(},
           "interior": {"preset": "potato", "ior": 1, "technique": ")" +
               technique + R"("}}]})";
    }

    /// Of the pixels that are compared.
    struct Loop {
        std::vector<glm::ivec2> pixels;
        std::vector<glm::dvec3> values;
    };

    static Loop double_loop(const RenderScene& scene, const Image& depth, const Visible& visible) {
        Loop loop;
        for (int y = kStride / 2; y < kSize; y += kStride)
            for (int x = kStride / 2; x < kSize; x += kStride)
                if (depth.at(x, y, 0) > 0.0f) loop.pixels.emplace_back(x, y);
        loop.values.resize(loop.pixels.size());
        const glm::vec3 to_light(scene.lights.front().transform[2]);
        parallel_for(0, loop.pixels.size(), 4, [&](size_t first, size_t last) {
            for (size_t i = first; i < last; ++i) {
                const glm::ivec2 at = loop.pixels[i];
                loop.values[i] = over_mesh(scene.surfaces.front(), place_of(scene, at.x, at.y, depth.at(at.x, at.y, 0)),
                                           to_light, visible);
            }
        });
        return loop;
    }

    /// Prints them as well.
    static LoopErrors errors_of(const Image& radiance, const Loop& loop) {
        constexpr int kBlocks = kSize / kBlock;
        std::array<glm::dvec3, size_t(kBlocks * kBlocks)> found{}, truth{};
        glm::dvec3 all_found(0.0), all_truth(0.0);
        LoopErrors errors{.pixels = loop.pixels.size()};
        for (size_t i = 0; i < loop.pixels.size(); ++i) {
            const glm::ivec2 at = loop.pixels[i];
            const auto block = size_t(at.y / kBlock * kBlocks + at.x / kBlock);
            const glm::dvec3 value(radiance.at(at.x, at.y, 0), radiance.at(at.x, at.y, 1), radiance.at(at.x, at.y, 2));
            found[block] += value;
            truth[block] += loop.values[i];
            all_found += value;
            all_truth += loop.values[i];
        }
        for (size_t b = 0; b < found.size(); ++b)
            for (int c = 0; c < 3; ++c)
                if (truth[b][c] > 0.02 * all_truth[c] / double(found.size()))
                    errors.worst_block = std::max(errors.worst_block, std::abs(found[b][c] / truth[b][c] - 1.0));
        errors.mean = all_found / all_truth;
        const glm::dvec3 least = 0.1 * all_truth / double(loop.pixels.size());
        for (size_t i = 0; i < loop.pixels.size(); ++i)
            for (int c = 0; c < 3; ++c) {
                const glm::ivec2 at = loop.pixels[i];
                const double off = double(radiance.at(at.x, at.y, c)) - loop.values[i][c];
                errors.relmse += off * off / (loop.values[i][c] * loop.values[i][c] + least[c] * least[c]);
            }
        errors.relmse /= 3.0 * double(std::max<size_t>(loop.pixels.size(), 1));
        std::printf("%zu pixels: mean %.4f %.4f %.4f of the double loop, worst block off by %.4f, relMSE %.6f\n",
                    errors.pixels, errors.mean.x, errors.mean.y, errors.mean.z, errors.worst_block, errors.relmse);
        return errors;
    }

    void SetUp() override {
        RendererTest::SetUp();
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::temp_directory_path() /
                  ("tyndall_" + std::string(test->name()) + "_" + std::to_string(getpid()));
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override {
        std::filesystem::remove_all(folder_);
        RendererTest::TearDown();
    }
    std::filesystem::path folder_;

 private:
    static glm::vec3 place_of(const RenderScene& scene, int x, int y, float depth) {
        const float t = std::tan(0.5f * scene.camera.vertical_fov), far = scene.camera.near_m / depth;
        const glm::vec3 along((2.0f * (float(x) + 0.5f) / kSize - 1.0f) * t,
                              (1.0f - 2.0f * (float(y) + 0.5f) / kSize) * t, -1.0f);
        return glm::vec3(scene.camera.transform * glm::vec4(far * along, 1.0f));
    }

    static glm::dvec3 over_mesh(const Surface& surface, const glm::vec3& at, const glm::vec3& to_light,
                                const Visible& visible) {
        const Mesh& mesh = surface.mesh->mesh;
        glm::dvec3 sum(0.0);
        for (size_t t = 0; t < mesh.triangle_count(); ++t) {
            std::array<glm::vec3, 3> p, n;
            for (size_t k = 0; k < 3; ++k) {
                const uint32_t i = mesh.indices[3 * t + k];
                p[k] = glm::vec3(surface.transform * glm::vec4(mesh.positions[i], 1.0f));
                n[k] = glm::normalize(glm::mat3(surface.transform) * mesh.normals[i]);
            }
            sum += over_triangle(p, n, at, to_light, 1.0 / 700.0, visible);
        }
        return sum / std::numbers::pi;
    }
};

}  // namespace tyndall::translucency
