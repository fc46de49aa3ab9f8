#include "scene/particles.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/error.h"
#include "core/parallel.h"
#include "core/paths.h"
#include "geometry/bounds.h"
#include "geometry/points.h"

namespace tyndall {
namespace {

constexpr size_t kMostParticles = 10'000'000;
constexpr float kSmallestVoxels = 0.9f;  ///< radius: such a ball covers a voxel's centre wherever it lies

[[noreturn]] void fail(const std::string& file, int line, std::string message, std::string expected) {
    throw Error(Diagnostic{{file, line}, std::move(message), std::move(expected), {}});
}

/// The numbers of a line up to a comment.
std::vector<float> numbers_of(std::string_view line, const std::string& file, int number) {
    constexpr std::string_view kBetween = " \t\r,;";
    line = line.substr(0, line.find('#'));
    std::vector<float> numbers;
    for (size_t at = line.find_first_not_of(kBetween); at != std::string_view::npos;
         at = line.find_first_not_of(kBetween, at)) {
        const std::string_view word = line.substr(at, line.find_first_of(kBetween, at) - at);
        float value = 0.0f;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc{} || end != word.data() + word.size() || !std::isfinite(value))
            fail(file, number, "'" + std::string(word.substr(0, 40)) + "' is no number", "x y z [radius [weight]]");
        numbers.push_back(value);
        at += word.size();
    }
    return numbers;
}

std::vector<Particle> read_text(const std::string& text, const std::string& file) {
    std::vector<Particle> particles;
    int number = 0;
    for (std::string_view rest = text; !rest.empty();) {
        const size_t end = rest.find('\n');
        const std::vector<float> v = numbers_of(rest.substr(0, end), file, ++number);
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
        if (v.empty()) continue;
        if (v.size() < 3 || v.size() > 5)
            fail(file, number, fmt::format("{} numbers in a line", v.size()), "x y z [radius [weight]]");
        particles.push_back({{v[0], v[1], v[2]}, v.size() > 3 ? v[3] : 0.0f, v.size() > 4 ? v[4] : 1.0f});
    }
    return particles;
}

bool counts(const Particle& p) {
    const float sum = p.centre.x + p.centre.y + p.centre.z + p.radius_m + p.weight;
    return std::isfinite(sum) && p.radius_m > 0.0f && p.weight > 0.0f;
}

/// Adds what a ball has in one layer of voxels.
void splat(const Particle& p, int z, Volume& volume) {
    const glm::vec3 low = (p.centre - p.radius_m - volume.low_m) / volume.voxel_m - 0.5f;
    const glm::vec3 high = (p.centre + p.radius_m - volume.low_m) / volume.voxel_m - 0.5f;
    const glm::ivec3 first = glm::max(glm::ivec3(glm::ceil(low)), glm::ivec3(0));
    const glm::ivec3 last = glm::min(glm::ivec3(glm::floor(high)), volume.size - 1);
    if (z < first.z || z > last.z) return;
    const float per_radius2 = 1.0f / (p.radius_m * p.radius_m);
    for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x) {
            const glm::vec3 away = volume.low_m + (glm::vec3(x, y, z) + 0.5f) * volume.voxel_m - p.centre;
            const float inside = std::max(1.0f - glm::dot(away, away) * per_radius2, 0.0f);
            const size_t row = size_t(z) * size_t(volume.size.y) + size_t(y);
            volume.values[row * size_t(volume.size.x) + size_t(x)] += p.weight * inside * inside;
        }
}

}  // namespace

std::vector<Particle> load_particles(const std::filesystem::path& file) {
    const std::string text = paths::read_file(file);
    std::vector<Particle> particles;
    if (text.starts_with("ply")) {
        for (const Point& point : read_points(text, file.string())) particles.push_back({point.place, point.radius});
    } else {
        particles = read_text(text, file.string());
    }
    if (particles.empty())
        fail(file.string(), 0, "there are no particles in the file", "lines of x y z, or a PLY file");
    if (particles.size() > kMostParticles)
        fail(file.string(), 0, fmt::format("{} particles", particles.size()),
             fmt::format("at most {}", kMostParticles));
    return particles;
}

Volume rasterised(std::span<const Particle> particles, int resolution) {
    std::vector<Particle> balls;
    std::ranges::copy_if(particles, std::back_inserter(balls), counts);
    if (balls.empty()) throw Error("there are no particles (expected one or more with a radius and a weight above 0)");
    Bounds box;
    for (const Particle& p : balls) {
        box.add(p.centre - p.radius_m);
        box.add(p.centre + p.radius_m);
    }
    const glm::vec3 size = box.size();
    const float voxel = std::max({size.x, size.y, size.z}) / float(resolution);
    if (!(voxel > 0.0f && std::isfinite(voxel))) throw Error("the particles' places are too far apart, or too near");
    Volume volume;
    volume.voxel_m = glm::vec3(voxel);
    volume.size = glm::ivec3(glm::ceil(size / voxel - 1e-3f)) + 2;
    volume.low_m = box.centre() - 0.5f * voxel * glm::vec3(volume.size);
    volume.values.assign(size_t(volume.size.x) * size_t(volume.size.y) * size_t(volume.size.z), 0.0f);
    for (Particle& p : balls) {
        const float wide = std::max(p.radius_m, kSmallestVoxels * voxel), ratio = p.radius_m / wide;
        p.radius_m = wide;
        p.weight *= ratio * ratio * ratio;
    }
    parallel_for(0, size_t(volume.size.z), 1, [&](size_t first, size_t last) {
        for (size_t z = first; z < last; ++z)
            for (const Particle& p : balls) splat(p, int(z), volume);
    });
    return volume;
}

}  // namespace tyndall
