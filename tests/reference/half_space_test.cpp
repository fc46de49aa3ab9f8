// Half-spaces against Chandrasekhar's solution, against measurements, and against an independent program.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "half_space.h"

namespace tyndall::reference {
namespace {

using glm::dvec3;
using glm::vec3;

TEST(HalfSpace, IndexMatchedIsChandrasekhars) {
    // 1 - H(1) sqrt(1 - albedo), where H(1) is 2.9078 for albedo 1 as tabulated
    EXPECT_NEAR((1.0 - chandrasekhar_reflectance(1.0 - 1e-8, 1.0)) / 1e-4, 2.9078, 2e-3);
    for (const vec3& albedo : {vec3(0.3f, 0.5f, 0.8f), vec3(0.9f, 0.99f, 0.999f)})
        for (const float angle : {0.0f, 60.0f, 80.0f}) {
            const double cosine = std::cos(glm::radians(static_cast<double>(angle)));
            dvec3 truth;
            for (int c = 0; c < 3; ++c) truth[c] = chandrasekhar_reflectance(static_cast<double>(albedo[c]), cosine);
            const int64_t samples = albedo.x < 0.5f ? 2048 : 512;
            expect_near(fmt::format("albedos {} {} {} at {} degrees", albedo.x, albedo.y, albedo.z, angle),
                        half_space_reflectance(albedo, 1.0f, angle, 16, samples), truth, 0.005);
        }
}

/// Reduced scattering and absorption (1/mm), and the diffuse reflectance that Jensen et al. ("A Practical Model for
/// Subsurface Light Transport", 2001) measured.
struct Material {
    const char* name;
    dvec3 scattering, absorption, measured;
    float eta;
};
constexpr double kMeasured = 0.03;
const Material kMaterials[] = {{"apple", {2.29, 2.39, 1.97}, {0.0030, 0.0034, 0.046}, {0.85, 0.84, 0.53}, 1.3f},
                               {"chicken 1", {0.15, 0.21, 0.38}, {0.015, 0.077, 0.19}, {0.31, 0.15, 0.10}, 1.3f},
                               {"chicken 2", {0.19, 0.25, 0.32}, {0.018, 0.088, 0.20}, {0.32, 0.16, 0.10}, 1.3f},
                               {"cream", {7.38, 5.47, 3.15}, {0.0002, 0.0028, 0.0163}, {0.98, 0.90, 0.73}, 1.3f},
                               {"ketchup", {0.18, 0.07, 0.03}, {0.061, 0.97, 1.45}, {0.16, 0.01, 0.00}, 1.3f},
                               {"marble", {2.19, 2.62, 3.00}, {0.0021, 0.0041, 0.0071}, {0.83, 0.79, 0.75}, 1.5f},
                               {"potato", {0.68, 0.70, 0.55}, {0.0024, 0.0090, 0.12}, {0.77, 0.62, 0.21}, 1.3f},
                               {"skimmed milk", {0.70, 1.22, 1.90}, {0.0014, 0.0025, 0.0142}, {0.81, 0.81, 0.69}, 1.3f},
                               {"skin 1", {0.74, 0.88, 1.01}, {0.032, 0.17, 0.48}, {0.44, 0.22, 0.13}, 1.3f},
                               {"skin 2", {1.09, 1.59, 1.79}, {0.013, 0.070, 0.145}, {0.63, 0.44, 0.34}, 1.3f},
                               {"whole milk", {2.55, 3.21, 3.77}, {0.0011, 0.0024, 0.014}, {0.91, 0.88, 0.76}, 1.3f}};

TEST(HalfSpace, ReturnsWhatWasMeasured) {
    double worst = 0.0;
    for (const Material& material : kMaterials) {
        const vec3 albedo(material.scattering / (material.scattering + material.absorption));
        const dvec3 found = half_space_reflectance(albedo, material.eta, 0.0f, 8, 256).mean;
        for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(found[c] - material.measured[c]));
        fmt::print("{}: {:.3f} {:.3f} {:.3f}, measured {:.2f} {:.2f} {:.2f}\n", material.name, found.x, found.y,
                   found.z, material.measured.x, material.measured.y, material.measured.z);
    }
    expect_below("farthest from the measured diffuse reflectance", worst, kMeasured);
}

TEST(HalfSpace, AgreesWithAnIndependentProgram) {
    // Seven half-spaces by a stand-alone Monte Carlo program with 2e5 photons each, exact to 0.002.
    struct Row {
        dvec3 scattering, absorption, exact;
        float eta;
    };
    const Row rows[] = {{{0.68, 0.55, 0.70}, {0.0024, 0.12, 0.0014}, {0.762, 0.195, 0.811}, 1.3f},
                        {{0.74, 1.01, 0.18}, {0.032, 0.48, 0.061}, {0.433, 0.113, 0.145}, 1.3f},
                        {{2.19, 2.19, 2.19}, {0.0021, 0.0021, 0.0021}, {0.805, 0.805, 0.805}, 1.5f}};
    double worst = 0.0;
    for (const Row& row : rows) {
        const vec3 albedo(row.scattering / (row.scattering + row.absorption));
        const Measured found = half_space_reflectance(albedo, row.eta, 0.0f, 16, 512);
        for (int c = 0; c < 3; ++c) {
            worst = std::max(worst, std::abs(found.mean[c] - row.exact[c]));
            EXPECT_LT(3.0 * found.error[c], 0.005) << "too few samples to tell";
        }
    }
    expect_below("farthest from the independent program", worst, 0.005);
}

}  // namespace
}  // namespace tyndall::reference
