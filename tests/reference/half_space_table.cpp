// Prints docs/half_space_albedo.md's table: how much light half-spaces of the measured materials return.
// usage: half_space_table PRESET.json...

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "half_space.h"
#include "physics/physics.h"

namespace {

using namespace tyndall;
using glm::vec3;

/// Three numbers of a preset.
vec3 three(const nlohmann::json& list) {
    return {list.at(0).get<float>(), list.at(1).get<float>(), list.at(2).get<float>()};
}

void print_row(const std::string& name, const vec3& scattering, const vec3& absorption, float eta) {
    constexpr int64_t kSamples = 128;
    const vec3 albedo = scattering / (scattering + absorption);
    std::string row = fmt::format("| {} | {} |", name, eta);
    for (int c = 0; c < 3; ++c) row += fmt::format(" {:.5f}", albedo[c]);
    for (const float angle : {0.0f, 60.0f}) {
        const float mirrored = physics::fresnel_dielectric(std::cos(glm::radians(angle)), eta);
        row += " |";
        // a half-space that does not absorb returns all that enters, after more bounces than one can follow
        const bool white = absorption == vec3(0.0f);
        const auto found = white ? reference::Measured{glm::dvec3(1.0 - static_cast<double>(mirrored))}
                                 : reference::half_space_reflectance(albedo, eta, angle, 16, kSamples);
        for (int c = 0; c < 3; ++c) row += fmt::format(" {:.4f}", found.mean[c]);
        row += fmt::format(" | {:.4f}", std::max(found.error.x, std::max(found.error.y, found.error.z)));
    }
    fmt::print("{} |\n", row);
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    fmt::print(
        "| material | index | albedo R G B | at 0 degrees | +- | at 60 degrees | +- "
        "|\n|---|---|---|---|---|---|---|\n");
    for (int i = 1; i < argc; ++i) {
        std::ifstream file(argv[i]);
        const nlohmann::json preset = nlohmann::json::parse(file);
        const nlohmann::json& optics = preset.at("optics").at("coefficients_per_mm");
        print_row(std::filesystem::path(argv[i]).stem().string(), three(optics.at("scattering")),
                  three(optics.at("absorption")), preset.at("ior").get<float>());
    }
}
