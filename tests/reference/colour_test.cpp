// Coloured coefficients: all channels share their flights, and none is biased by the others.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "scenes.h"

namespace tyndall::reference {
namespace {

using glm::vec3;

constexpr double kLimit = 0.01;  ///< of three standard errors

/// A blobby medium around a ball with a scattering inside, all with coefficients that differ widely between channels;
/// `channel` 0..2 gives every channel that one's, 3 leaves them.
RenderScene scene_of(int channel) {
    const auto seen = [&](const vec3& v) { return channel < 3 ? vec3(v[channel]) : v; };
    RenderScene scene = uniform_field(camera_at({0.0f, 0.5f, 4.0f}, vec3(0.0f), 30.0f));
    Light lamp;
    lamp.intensity = vec3(6.0f);
    lamp.transform[3] = glm::vec4(1.5f, 1.5f, 1.0f, 1.0f);
    scene.lights.push_back(lamp);
    Medium medium;
    medium.transform = between(vec3(-1.2f), vec3(1.2f));
    medium.sigma_s_per_m = seen({0.2f, 1.0f, 3.0f});
    medium.sigma_a_per_m = seen({0.8f, 0.1f, 0.0f});
    medium.emission_cd_m2_per_m = seen({0.3f, 0.1f, 0.0f});
    medium.phase = henyey_greenstein(0.4f);
    medium.density = BlobDensity{{{vec3(0.1f, 0.0f, 0.0f), 0.3f, 1.2f}}};
    scene.media.push_back(medium);
    Surface ball = shape(Primitive::sphere, between(vec3(-0.6f), vec3(0.6f)));
    ScatteringInterior interior;
    interior.sigma_s_per_m = seen({8.0f, 2.0f, 0.5f});
    interior.sigma_a_per_m = seen({0.0f, 0.2f, 2.0f});
    interior.eta = 1.3f;
    ball.interior = interior;
    scene.surfaces.push_back(ball);
    return scene;
}

TEST(Colour, ChannelsAreWhatTheyAreAlone) {
    const TraceSettings settings = square_picture(16, 768);
    const Measured coloured = measure(scene_of(3), settings, 768);
    for (int c = 0; c < 3; ++c) {
        TraceSettings other = settings;
        other.seed = static_cast<uint32_t>(c) + 1;
        const Measured grey = measure(scene_of(c), other, 512);
        const double error = std::sqrt(coloured.error[c] * coloured.error[c] + grey.error[c] * grey.error[c]);
        const double z = (coloured.mean[c] - grey.mean[c]) / error;
        fmt::print("channel {}: {:.5f} in colour, {:.5f} alone, off by {:+.3f} %, z {:+.2f} (limit 3.5)\n", c,
                   coloured.mean[c], grey.mean[c], 100.0 * (coloured.mean[c] / grey.mean[c] - 1.0), z);
        EXPECT_LT(std::abs(z), 3.5) << "channel " << c;
        EXPECT_LT(3.0 * error / grey.mean[c], kLimit) << "too few samples to tell";
        EXPECT_EQ(grey.mean[0], grey.mean[2]) << "grey stays grey";
    }
}

}  // namespace
}  // namespace tyndall::reference
