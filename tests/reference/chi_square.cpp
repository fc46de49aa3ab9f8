#include "chi_square.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "physics/physics.h"

namespace tyndall::reference {

double chi_square_tail(double chi_square, double degrees) {
    const double spread = 2.0 / (9.0 * degrees);
    const double z = (std::cbrt(chi_square / degrees) - (1.0 - spread)) / std::sqrt(spread);
    return 0.5 * std::erfc(z / std::sqrt(2.0));
}

void expect_distribution(const std::string& what, const std::vector<double>& expected,
                         const std::vector<double>& observed) {
    ASSERT_EQ(expected.size(), observed.size());
    double sum = 0.0, rare_expected = 0.0, rare = 0.0, total = 0.0;
    int bins = 0;
    const auto add = [&](double wanted, double found) {
        sum += (found - wanted) * (found - wanted) / wanted;
        ++bins;
    };
    for (size_t i = 0; i < expected.size(); ++i) {
        total += expected[i];
        if (expected[i] >= 10.0)
            add(expected[i], observed[i]);
        else
            rare_expected += expected[i], rare += observed[i];
    }
    if (rare_expected >= 10.0)
        add(rare_expected, rare);
    else
        EXPECT_LT(rare, rare_expected + 20.0) << what << ": samples where there should be none";
    ASSERT_GT(bins, 1) << what;
    const double found = std::accumulate(observed.begin(), observed.end(), 0.0);
    const double p = chi_square_tail(sum, bins - 1);
    fmt::print("{}: {} bins, chi-square {:.1f}, p {:.3f} (limit {}); densities add up to {:.5f}\n", what, bins, sum, p,
               kSignificance, total / found);
    EXPECT_GT(p, kSignificance) << what;
    EXPECT_NEAR(total / found, 1.0, 1e-3) << what;
}

size_t DirectionBins::of(const glm::vec3& direction) const {
    const float z = (direction.z - low) / (1.0f - low);
    if (z < 0.0f) return count();
    const float turn = std::atan2(direction.y, direction.x) / physics::kTwoPi + 0.5f;
    const int row = std::min(static_cast<int>(z * static_cast<float>(rows)), rows - 1);
    const int column = std::clamp(static_cast<int>(turn * static_cast<float>(columns)), 0, columns - 1);
    return static_cast<size_t>(row * columns + column);
}

glm::vec3 DirectionBins::direction(size_t bin, float x, float y) const {
    const auto row = static_cast<float>(bin / static_cast<size_t>(columns)),
               column = static_cast<float>(bin % static_cast<size_t>(columns));
    const float z = low + (1.0f - low) * (row + y) / static_cast<float>(rows);
    return physics::spherical_direction(z, physics::kTwoPi * ((column + x) / static_cast<float>(columns) - 0.5f));
}

double DirectionBins::solid_angle() const {
    return static_cast<double>(physics::kTwoPi) * (1.0 - static_cast<double>(low)) / static_cast<double>(count());
}

std::vector<double> DirectionBins::integrals(int points, FunctionRef<double(const glm::vec3&)> density) const {
    std::vector<double> sums(count());
    const double share = solid_angle() / (static_cast<double>(points) * points);
    for (size_t bin = 0; bin < sums.size(); ++bin)
        for (int y = 0; y < points; ++y)
            for (int x = 0; x < points; ++x)
                sums[bin] += share * density(direction(bin, (static_cast<float>(x) + 0.5f) / static_cast<float>(points),
                                                       (static_cast<float>(y) + 0.5f) / static_cast<float>(points)));
    return sums;
}

}  // namespace tyndall::reference
