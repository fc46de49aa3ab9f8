// The Mie series against published values, and the tables that are made with it.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/paths.h"
#include "mie/mie_series.h"
#include "mie/mie_table.h"
#include "scene/phase_table.h"
#include "temporary_folder.h"

namespace tyndall::mie {
namespace {

constexpr double kPi = std::numbers::pi;

std::vector<double> intensity(const MieSeries& series, const std::vector<double>& angles_deg) {
    std::vector<double> cosines, values(angles_deg.size(), 0.0);
    for (const double angle : angles_deg) cosines.push_back(std::cos(angle * kPi / 180.0));
    series.add_intensity(cosines, 1.0, values);
    return values;
}

struct Published {
    double x;
    std::complex<double> m;
    double extinction, scattering, mean_cosine;
};

TEST(MieSeries, GivesThePublishedEfficiencies) {
    // Bohren & Huffman, appendix A; Wiscombe, "Mie Scattering Calculations", NCAR/TN-140+STR (1979), tables
    const Published published[] = {
        {5.21282, {1.55, 0.0}, 3.10543, 3.10543, 0.63314},   {1.0, {1.33, 1e-5}, 0.093952, 0.093923, 0.184517},
        {100.0, {1.33, 1e-5}, 2.101321, 2.096594, 0.868959}, {10000.0, {1.33, 1e-5}, 2.004089, 1.723857, 0.907840},
        {1.0, {1.5, 1.0}, 2.336321, 0.663454, 0.192136},     {100.0, {1.5, 1.0}, 2.097502, 1.283697, 0.850252}};
    for (const Published& p : published) {
        const MieSeries series(p.x, p.m);
        EXPECT_NEAR(series.extinction(), p.extinction, 1e-5 * p.extinction) << p.x;
        EXPECT_NEAR(series.scattering(), p.scattering, 1e-5 * p.scattering) << p.x;
        EXPECT_NEAR(series.mean_cosine(), p.mean_cosine, 1e-5) << p.x;
    }
    const double back = 4.0 * intensity(MieSeries(5.21282, 1.55), {180.0})[0] / (5.21282 * 5.21282);
    EXPECT_NEAR(back, 2.92534, 1e-4) << "Bohren & Huffman's QBACK";
}

TEST(MieSeries, IntensityHoldsTheScatteringAndItsMeanCosine) {
    const MieSeries series(30.0, {1.33, 1e-4});
    double sum = 0.0, cosine = 0.0;
    constexpr int kSteps = 4000;
    std::vector<double> angles;
    for (int i = 0; i < kSteps; ++i) angles.push_back(180.0 * (i + 0.5) / kSteps);
    const std::vector<double> values = intensity(series, angles);
    for (int i = 0; i < kSteps; ++i) {
        const double angle = angles[size_t(i)] * kPi / 180.0;
        const double share = values[size_t(i)] * std::sin(angle) * 2.0 * kPi * kPi / kSteps;
        sum += share;
        cosine += share * std::cos(angle);
    }
    EXPECT_NEAR(sum / (kPi * 900.0), series.scattering(), 1e-4);
    EXPECT_NEAR(cosine / sum, series.mean_cosine(), 1e-4);
}

TEST(MieSeries, SmallBallsScatterAsRayleighSays) {
    const double x = 0.01;
    const std::vector<double> values = intensity(MieSeries(x, 1.33), {0.0, 90.0, 180.0});
    EXPECT_NEAR(values[1] / values[0], 0.5, 1e-3);
    EXPECT_NEAR(values[2] / values[0], 1.0, 1e-3);
    const double k = (1.33 * 1.33 - 1.0) / (1.33 * 1.33 + 2.0);
    EXPECT_NEAR(MieSeries(x, 1.33).scattering() / (8.0 / 3.0 * std::pow(x, 4.0) * k * k), 1.0, 1e-3);
}

TEST(Water, HasTheIndexThatHandbooksList) {
    EXPECT_NEAR(water_index(589.0).real(), 1.3330, 2e-4);
    EXPECT_NEAR(water_index(404.7).real(), 1.3427, 3e-4);
    EXPECT_NEAR(water_index(706.5).real(), 1.3300, 3e-4);
    EXPECT_GT(water_index(700.0).imag(), 10.0 * water_index(450.0).imag());
}

size_t peak(const DropletTable& table, int channel, double from_deg, double to_deg) {
    size_t best = 0;
    for (size_t i = 0; i < table.values.size(); ++i)
        if (table.angles_deg[i] >= from_deg && table.angles_deg[i] <= to_deg &&
            (best == 0 || table.values[i][channel] > table.values[best][channel]))
            best = i;
    return best;
}

TEST(DropletTable, LargeDropsMakeARainbow) {
    const DropletTable table =
        droplet_table({.radius_um = 100.0, .variance = 0.02, .sizes = 16, .wavelengths = 6, .step_deg = 0.5});
    const size_t red = peak(table, 0, 132.0, 150.0), blue = peak(table, 2, 132.0, 150.0);
    RecordProperty("red_bow_deg", std::to_string(table.angles_deg[red]));
    std::printf("rainbow: red at %.1f, blue at %.1f degrees\n", table.angles_deg[red], table.angles_deg[blue]);
    // by rays: red at 137.6, blue at 139.4; waves move the bow of small drops outwards (Airy)
    EXPECT_NEAR(table.angles_deg[red], 138.5, 1.6);
    EXPECT_GT(table.angles_deg[blue], table.angles_deg[red]);
    const auto at = [&](double angle) { return table.values[size_t(std::lround(angle / 0.5))].x; };
    EXPECT_GT(table.values[red].x, 3.0 * at(130.0)) << "Alexander's dark band";
    EXPECT_GT(table.mean_cosine.y, 0.8);
}

TEST(DropletTable, CloudsHaveAGlory) {
    const DropletTable table =
        droplet_table({.radius_um = 6.0, .variance = 0.02, .sizes = 24, .wavelengths = 8, .step_deg = 0.5});
    const auto at = [&](double angle) { return table.values[size_t(std::lround(angle / 0.5))].y; };
    std::printf("glory: %.4f at 180, %.4f at 170, %.4f at 120 degrees\n", at(180.0), at(170.0), at(120.0));
    EXPECT_GT(at(180.0), 1.5 * at(170.0));
    EXPECT_GT(at(180.0), 4.0 * at(120.0));
    EXPECT_NEAR(table.mean_cosine.y, 0.85, 0.03);
}

using Tables = TemporaryFolder;

TEST_F(Tables, AreWhatTabulatedPhasesRead) {
    const DropletCloud cloud{.radius_um = 2.0, .variance = 0.1, .sizes = 8, .wavelengths = 4, .step_deg = 1.0};
    const DropletTable table = droplet_table(cloud);
    paths::write_file_atomically(folder_ / "t.txt", table_text(table, cloud));
    const PhaseTable read = load_phase_table(folder_ / "t.txt", "t");
    ASSERT_EQ(read.values.size(), 181u);
    for (size_t i = 0; i < read.values.size(); ++i)
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(double(read.values[i][c]) / table.values[i][c], 1.0, 2e-3) << i;
}

}  // namespace
}  // namespace tyndall::mie
