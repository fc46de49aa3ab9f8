// What media are made of: puffs, swirls, noise between samples, ramps, the glow of hot things.

#include "physics_test.h"

namespace tyndall::physics {
namespace {

vec3 place(Random& random) {
    return {random.between(-400, 400), random.between(-400, 400), random.between(-400, 400)};
}

TEST(CellularNoise, HasTheMomentsThatItsNormalisationAssumes) {
    Random random(5);
    double sum = 0, squares = 0, steepest = 0;
    constexpr int kCount = 200000;
    for (int i = 0; i < kCount; ++i) {
        const vec3 p = place(random);
        const double d = cell_distance(p, 77u);
        sum += d;
        squares += d * d;
        if (i % 10 == 0)
            steepest = std::max(steepest, std::abs(double(cell_distance(p + vec3(0, 0.01f, 0), 77u)) - d) / 0.01);
    }
    const double mean = sum / kCount, deviation = std::sqrt(squares / kCount - mean * mean);
    measured("mean distance to a cell's point", mean);
    EXPECT_NEAR(mean / double(kCellDistanceMean), 1.0, 0.02);
    EXPECT_NEAR(deviation / double(kCellDistanceDeviation), 1.0, 0.02);
    EXPECT_LE(steepest, 1.01) << "a distance cannot change faster than the place; nowhere is there a seam";
}

TEST(NoiseSwirl, IsTheCurlThatItSays) {
    Random random(6);
    double squares = 0, divergence = 0, change = 0;
    constexpr int kCount = 20000;
    for (int i = 0; i < kCount; ++i) {
        const vec3 p = 0.1f * place(random);
        const vec3 swirl = noise_swirl(p, 0.4f);
        squares += double(dot(swirl, swirl));
        if (i % 10 != 0) continue;
        double sum = 0;
        const float h = 0.02f;
        for (int axis = 0; axis < 3; ++axis) {
            vec3 step(0.0f);
            step[axis] = h;
            const vec3 slope = (noise_swirl(p + step, 0.4f) - noise_swirl(p - step, 0.4f)) / (2 * h);
            sum += double(slope[axis]);
            change += double(dot(slope, slope));
        }
        divergence += sum * sum;
    }
    measured("root mean square of the swirl", std::sqrt(squares / kCount));
    measured("its divergence over its change", std::sqrt(divergence / change));
    EXPECT_NEAR(std::sqrt(squares / kCount), 1.0, 0.05);
    EXPECT_LT(std::sqrt(divergence / change), 0.02) << "what flows in flows out";
}

TEST(GradientNoise, HasTheSlopeThatItSays) {
    Random random(7);
    for (int i = 0; i < 3000; ++i) {
        const vec3 p = 0.02f * place(random), slope = gradient_noise_slope(p, 9u);
        for (int axis = 0; axis < 3; ++axis) {
            vec3 step(0.0f);
            step[axis] = 1e-3f;
            EXPECT_NEAR((gradient_noise(p + step, 9u) - gradient_noise(p - step, 9u)) / 2e-3f, slope[axis], 3e-3f);
        }
    }
}

TEST(FilteredNoise, IsTheNoiseItselfForSamplesAtEveryPlace) {
    Random random(8);
    for (int i = 0; i < 2000; ++i) {
        const vec3 p = place(random);
        EXPECT_NEAR(filtered_noise_density(p, NOISE_PERLIN, 4, 0.5f, 0.0f), noise_density(p, 4, 0.5f), 1e-4f);
    }
}

/// Greatest difference between neighbouring samples' mean and the same mean of the noise itself.
TEST(FilteredNoise, KeepsTheAmountAndLosesTheFlicker) {
    for (const int kind : {NOISE_PERLIN, NOISE_WORLEY})
        for (const float coverage : {0.5f, 1.0f}) {
            const auto statistics = [&](float spacing) {
                Random random(9);
                double sum = 0, squares = 0;
                constexpr int kCount = 8000;
                for (int i = 0; i < kCount; ++i) {
                    const double density = filtered_noise_density(place(random), kind, 4, coverage, spacing);
                    sum += density;
                    squares += density * density;
                }
                return std::pair(sum / kCount,
                                 std::sqrt(std::max(squares / kCount - sum * sum / kCount / kCount, 0.0)));
            };
            const auto [mean, deviation] = statistics(0.0f);
            const auto [far_mean, far_deviation] = statistics(1.0f);
            measured("mean of the noise", mean);
            // puffs are not normally distributed: their mean is off by more
            EXPECT_NEAR(mean, far_mean, kind == NOISE_PERLIN ? 0.02 : 0.13);
            EXPECT_GT(deviation, 0.15);
            EXPECT_LT(far_deviation, 1e-6) << "beyond the largest features only the mean is left";
            double before = deviation;
            for (const float spacing : {0.25f, 0.5f, 0.7f, 0.9f}) {
                const double now = statistics(spacing).second;
                EXPECT_LE(now, before + 0.01) << spacing;
                before = now;
            }
        }
}

TEST(Ramps, RiseFromOneEndToTheOther) {
    EXPECT_EQ(linear_ramp(vec3(-9, 0, 0), vec3(0), vec3(2, 0, 0)), 0.0f);
    EXPECT_FLOAT_EQ(linear_ramp(vec3(0.5f, 7, 3), vec3(0), vec3(2, 0, 0)), 0.25f);
    EXPECT_EQ(linear_ramp(vec3(9, 0, 0), vec3(0), vec3(2, 0, 0)), 1.0f);
    EXPECT_TRUE(std::isfinite(linear_ramp(vec3(1), vec3(2), vec3(2))));
    EXPECT_EQ(radial_ramp(vec3(0.1f, 0, 0), vec3(0), 0.2f, 0.6f), 0.0f);
    EXPECT_FLOAT_EQ(radial_ramp(vec3(0, 0.5f, 0), vec3(0), 0.2f, 0.6f), 0.75f);
    EXPECT_EQ(radial_ramp(vec3(0, 0, 3), vec3(0), 0.2f, 0.6f), 1.0f);
}

TEST(UnitBall, IsClippedLikeASphereWhateverTheDirectionsLength) {
    Random random(10);
    for (int i = 0; i < 3000; ++i) {
        const vec3 origin = 0.003f * place(random);
        const vec3 direction = normalize(place(random) + vec3(0.01f));
        const float length = random.between(0.1f, 5.0f);
        float a0 = 0, a1 = 10, b0 = 0, b1 = 10 / length;
        const bool sphere = clip_to_sphere(origin, direction, vec3(0), 0.5f, a0, a1);
        const bool ball = clip_to_unit_ball(origin, direction * length, b0, b1);
        if (!sphere && !ball) continue;
        ASSERT_LT(std::abs((a1 - a0) - (b1 - b0) * length), 2e-3f);
        if (sphere && a1 - a0 > 0.01f) {
            EXPECT_NEAR(a0, b0 * length, 1e-4f);
        }
    }
}

/// Planck's law through the observer's fit, integrated nanometre by nanometre; luminance in cd/m2.
double luminance(double kelvin) {
    double sum = 0;
    for (double nm = 360; nm < 831; nm += 1) {
        const auto lobe = [nm](double height, double middle, double below, double above) {
            const double t = (nm - middle) / (nm < middle ? below : above);
            return height * std::exp(-0.5 * t * t);
        };
        const double metres = nm * 1e-9;
        sum += (lobe(0.821, 568.8, 46.9, 40.5) + lobe(0.286, 530.9, 16.3, 31.1)) * 1.191042972e-16 /
               (std::pow(metres, 5) * std::expm1(0.014387769 / (metres * kelvin)));
    }
    return 683.0 * sum * 1e-9;
}

TEST(BlackBody, HasTheLuminanceThatPlancksLawGives) {
    double worst = 0;
    for (double kelvin = 1900; kelvin < 12000; kelvin *= 1.1) {  // below, blue is cut off
        const vec3 rgb = black_body_radiance(float(kelvin));
        const double y = 0.2126729 * double(rgb.x) + 0.7151522 * double(rgb.y) + 0.0721750 * double(rgb.z);
        worst = std::max(worst, std::abs(y / luminance(kelvin) - 1));
    }
    measured("worst relative error of a black body's luminance", worst);
    EXPECT_LT(worst, 2e-3);
}

TEST(BlackBody, IsThatOfTheOldCandelaAndWhiteLikeDaylight) {
    // until 1979 the candela was defined so: a black body where platinum freezes, at 2042 K, has 60 cd/cm2
    const vec3 platinum = black_body_radiance(2042.0f);
    const double y = 0.2126729 * double(platinum.x) + 0.7151522 * double(platinum.y) + 0.0721750 * double(platinum.z);
    measured("luminance where platinum freezes, cd/m2", y);
    EXPECT_NEAR(y / 6e5, 1.0, 0.02);
    const vec3 daylight = black_body_radiance(6504.0f);
    EXPECT_NEAR(daylight.x / daylight.y, 1.06f, 0.03f) << "a black body is a little pinker than D65";
    EXPECT_NEAR(daylight.z / daylight.y, 1.05f, 0.03f);
    EXPECT_EQ(black_body_radiance(300.0f), vec3(0.0f));
    const vec3 ember = black_body_radiance(900.0f);
    EXPECT_GT(ember.x, 20 * ember.y) << "red hot";
    EXPECT_EQ(ember.z, 0.0f);
    for (const float kelvin : {0.0f, -5.0f, 1e5f, 1e9f}) {
        const vec3 rgb = black_body_radiance(kelvin);
        EXPECT_TRUE(std::isfinite(rgb.x + rgb.y + rgb.z) && rgb.x >= 0) << kelvin;
    }
}

}  // namespace
}  // namespace tyndall::physics
