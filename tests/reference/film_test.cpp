// Films: whatever way the samples come together, the bits are the same; and the parts of the light add up.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <fstream>
#include <iterator>

#include "../unit/temporary_folder.h"
#include "core/error.h"
#include "core/parallel.h"
#include "scenes.h"

namespace tyndall::reference {
namespace {

using glm::vec3;

constexpr int kBatches = 8;

/// Fog, a lamp, a floor and a ball of glass full of milk: all kinds of meetings.
RenderScene crowded() {
    RenderScene scene;
    scene.camera = camera_at({0.0f, 1.0f, 4.0f}, vec3(0.0f, 0.3f, 0.0f), 40.0f);
    scene.sky.radiance = vec3(0.3f, 0.4f, 0.5f);
    Light lamp;
    lamp.intensity = {9.0f, 7.0f, 5.0f};
    lamp.transform[3] = glm::vec4(1.0f, 2.0f, 1.0f, 1.0f);
    scene.lights.push_back(lamp);
    scene.surfaces.push_back(shape(Primitive::box, between({-3.0f, -1.0f, -3.0f}, {3.0f, -0.5f, 3.0f}), Material{}));
    Surface ball = shape(Primitive::sphere, between({-0.5f, -0.4f, -0.5f}, {0.5f, 0.6f, 0.5f}));
    ScatteringInterior interior;
    interior.sigma_s_per_m = {5.0f, 3.0f, 2.0f};
    interior.sigma_a_per_m = {0.1f, 0.3f, 0.9f};
    interior.roughness = 0.3f;
    ball.interior = interior;
    scene.surfaces.push_back(ball);
    Medium fog;
    fog.transform = between(vec3(-2.0f), vec3(2.0f));
    fog.sigma_s_per_m = {0.2f, 0.25f, 0.3f};
    fog.emission_cd_m2_per_m = {0.02f, 0.0f, 0.01f};
    fog.phase = henyey_greenstein(0.5f);
    fog.density = HeightDensity{0.0f, 0.8f};
    scene.media.push_back(fog);
    return scene;
}

TraceSettings small_picture() {
    TraceSettings settings;
    settings.size = {40, 24};
    settings.batch = 4;
    settings.components = true;
    return settings;
}

void add(const Tracer& tracer, Film& film, int first, int step = 1, int end = kBatches) {
    for (int batch = first; batch < end; batch += step)
        ASSERT_TRUE(tracer.add_batch(film, batch, [] { return false; }));
}

std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

class Films : public TemporaryFolder {
 protected:
    [[nodiscard]] std::string saved(const Film& film) const {
        film.save(folder_ / "film.exr");
        return bytes_of(folder_ / "film.exr");
    }
    Tracer tracer_{crowded(), small_picture()};
    Film whole_ = tracer_.film("recipe");
    void SetUp() override {
        TemporaryFolder::SetUp();
        add(tracer_, whole_, 0);
    }
};

TEST_F(Films, ShardsAddUpToTheSameBits) {
    Film sum = tracer_.film("recipe");
    for (const int part : {2, 0, 1}) {
        Film shard = tracer_.film("recipe");
        add(tracer_, shard, part, 3);
        shard.save(folder_ / "shard.exr");
        sum.merge(Film::load(folder_ / "shard.exr"));
    }
    EXPECT_TRUE(saved(sum) == saved(whole_));
}

TEST_F(Films, ThreadsLeaveTheSameBits) {
    for (const size_t threads : {1u, 2u, 5u}) {
        const ThreadLimit limit(threads);
        Film film = tracer_.film("recipe");
        add(tracer_, film, 0);
        EXPECT_TRUE(saved(film) == saved(whole_)) << threads << " threads";
    }
}

TEST_F(Films, InterruptionsLeaveTheSameBits) {
    Film film = tracer_.film("recipe");
    add(tracer_, film, 0, 1, 3);
    const std::string before = saved(film);
    std::atomic<int> asked{0};
    EXPECT_FALSE(tracer_.add_batch(film, 3, [&] { return ++asked > 1; }));
    EXPECT_TRUE(saved(film) == before) << "a batch that was cancelled leaves nothing";
    Film resumed = Film::load(folder_ / "film.exr");
    EXPECT_EQ(resumed.batches(), 3);
    add(Tracer(crowded(), small_picture()), resumed, 3);
    EXPECT_TRUE(saved(resumed) == saved(whole_));
}

TEST_F(Films, OthersAreRefused) {
    const auto refused = [&](const Film& other, const std::string& words) {
        const std::string before = saved(whole_);
        try {
            whole_.merge(other);
            ADD_FAILURE() << "merged: " << words;
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
        }
        EXPECT_TRUE(saved(whole_) == before);
    };
    Film twice = tracer_.film("recipe");
    add(tracer_, twice, 5, 1, 6);
    refused(twice, "batch 5 of samples is in both films");
    refused(tracer_.film("another recipe"), "another recipe");
    TraceSettings larger = small_picture();
    larger.size.x += 1;
    refused(Tracer(crowded(), larger).film("recipe"), "41x24");
}

TEST_F(Films, ComponentsAddUp) {
    const Image radiance = whole_.radiance();
    const Image parts[] = {whole_.component(Component::emission), whole_.component(Component::surface),
                           whole_.component(Component::medium), whole_.component(Component::multiple)};
    double worst = 0.0, means[4] = {};
    for (size_t i = 0; i < radiance.value_count(); ++i) {
        double sum = 0.0;
        for (size_t k = 0; k < 4; ++k) {
            sum += static_cast<double>(parts[k].floats()[i]);
            means[k] += static_cast<double>(parts[k].floats()[i]) / static_cast<double>(radiance.value_count());
        }
        const auto all = static_cast<double>(radiance.floats()[i]);
        worst = std::max(worst, std::abs(sum - all) / std::max(all, 1e-3));
    }
    fmt::print("emission {:.4f}, surface {:.4f}, medium {:.4f}, multiple {:.4f}\n", means[0], means[1], means[2],
               means[3]);
    for (const double mean : means) EXPECT_GT(mean, 1e-3) << "every part is in this scene";
    expect_below("components against the radiance", worst, 1e-6);
}

TEST(Orders, SingleScatteringIsTheFirstThreeComponents) {
    TraceSettings settings = small_picture();
    settings.size = {24, 16};
    settings.batch = 128;
    const Film all = trace(crowded(), settings, 1024);
    settings.max_order = 1;
    settings.seed = 1;
    const Film single = trace(crowded(), settings, 1024);
    settings.min_order = 2;
    settings.max_order = std::numeric_limits<int>::max();
    settings.seed = 2;
    const Film rest = trace(crowded(), settings, 1024);
    const Measured one = mean_of(single), several = mean_of(rest);
    const glm::dvec3 first = mean_of(all, Component::emission).mean + mean_of(all, Component::surface).mean +
                             mean_of(all, Component::medium).mean;
    const glm::dvec3 others = mean_of(all, Component::multiple).mean;
    // the radiance's variance bounds that of its parts
    const glm::dvec3 error = mean_of(all).error;
    for (int c = 0; c < 3; ++c) {
        const double z1 = (one.mean[c] - first[c]) / std::hypot(one.error[c], error[c]);
        const double z2 = (several.mean[c] - others[c]) / std::hypot(several.error[c], error[c]);
        fmt::print(
            "channel {}: single {:.5f} and {:.5f}, z {:+.2f}; the rest {:.5f} and {:.5f}, z {:+.2f} (limit 3.5)\n", c,
            one.mean[c], first[c], z1, several.mean[c], others[c], z2);
        EXPECT_LT(std::abs(z1), 3.5);
        EXPECT_LT(std::abs(z2), 3.5);
        EXPECT_LT(std::hypot(one.error[c], error[c]) / first[c], 0.01) << "too few samples to tell";
    }
}

}  // namespace
}  // namespace tyndall::reference
