// What a round profile of a flat solid does not know, against photons: drift, limb, convexity.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <random>

#include "physics/physics.h"
#include "physics/profile_corrections.h"

namespace tyndall::physics {
namespace {

constexpr float kEta = 1.4f;
constexpr double kFlat = 1e7;  ///< radius of a ball that is as good as flat

/// Photons in a ball of extinction 1 and isotropic scattering, with a smooth boundary.
class BallPhotons {
 public:
    BallPhotons(double albedo, double radius) : albedo_(albedo), radius_(radius) {}

    double entered = 0.0, left = 0.0;
    glm::dvec3 moved{0.0};     ///< sum of where they left, about where they entered
    double mean_square = 0.0;  ///< sum, along the surface

    /// Enters at the top, at an angle whose cosine outside is this, toward +x.
    void enter(double cosine) {
        const double sine = std::sqrt(1.0 - cosine * cosine) / double(kEta);
        way_ = {sine, 0.0, -std::sqrt(1.0 - sine * sine)};
        at_ = {0.0, 0.0, 0.0};
        weight_ = 1.0 - double(fresnel_dielectric(float(cosine), kEta));
        entered += weight_;
        while (fly()) {
            weight_ *= albedo_;
            if (weight_ < 0.05 && random() < 0.5) return;
            if (weight_ < 0.05) weight_ *= 2.0;
            const double z = 2.0 * random() - 1.0, turn = 2.0 * std::numbers::pi * random();
            way_ = {std::sqrt(1.0 - z * z) * std::cos(turn), std::sqrt(1.0 - z * z) * std::sin(turn), z};
        }
    }
    double random() { return double(engine_() >> 11) * 0x1p-53; }

 private:
    /// To the next collision; false when next to nothing is left inside.
    bool fly() {
        double flight = -std::log(1.0 - random());
        for (;;) {
            // the ball's middle is at z = -radius; |at - middle|^2 - radius^2 without its large terms
            const double along = glm::dot(at_, way_) + radius_ * way_.z;
            const double inside = glm::dot(at_, at_) + 2.0 * radius_ * at_.z;
            const double root = std::sqrt(std::max(along * along - inside, 0.0));
            const double edge = along > 0.0 ? -inside / (along + root) : root - along;
            if (flight < edge) {
                at_ += flight * way_;
                return true;
            }
            at_ += edge * way_;
            flight -= edge;
            const glm::dvec3 normal = glm::normalize(at_ + glm::dvec3(0.0, 0.0, radius_));
            const double cosine = glm::dot(way_, normal);
            const double kept = double(fresnel_dielectric(float(cosine), 1.0f / kEta));
            left += weight_ * (1.0 - kept);
            moved += weight_ * (1.0 - kept) * at_;
            mean_square += weight_ * (1.0 - kept) * (at_.x * at_.x + at_.y * at_.y);
            weight_ *= kept;
            if (weight_ < 1e-4) return false;
            way_ -= 2.0 * cosine * normal;
        }
    }

    double albedo_, radius_;
    glm::dvec3 at_{0.0}, way_{0.0};
    double weight_ = 0.0;
    std::mt19937_64 engine_{3};
};

TEST(ProfileCorrections, AreWhatPhotonsDo) {
    constexpr int kPhotons = 60000;
    for (const double scattering : {0.96, 0.84}) {
        BallPhotons even(scattering, kFlat), steep(scattering, kFlat), slanted(scattering, kFlat);
        for (int i = 0; i < kPhotons; ++i) {
            even.enter(std::sqrt(even.random()));
            steep.enter(1.0);
            slanted.enter(0.5);
        }
        const double spread = std::sqrt(steep.mean_square / steep.left), albedo = even.left / even.entered;
        BallPhotons ball(scattering, 10.0 * spread);
        for (int i = 0; i < kPhotons; ++i) ball.enter(std::sqrt(ball.random()));
        const ProfileCorrections made = profile_corrections(glm::vec3(float(albedo)), glm::vec3(float(spread)), kEta);
        const double drift = slanted.moved.x / slanted.left;
        const double more = (slanted.left / slanted.entered) / (steep.left / steep.entered);
        const double convex = ball.left / ball.entered / albedo;
        std::printf(
            "albedo %.3f: drift %.3f, photons %.3f; 60 degrees over the normal %.3f, photons %.3f; a ball of "
            "ten spreads over a flat solid %.3f, photons %.3f\n",
            albedo, double(made.drift_m.x) * std::sqrt(0.75), drift, double(made.share(0.5f).x / made.share(1.0f).x),
            more, 1.0 + double(made.convex_m.x) / (10.0 * spread), convex);
        EXPECT_NEAR(double(made.drift_m.x) * std::sqrt(0.75) / drift, 1.0, 0.06);
        EXPECT_NEAR(double(made.share(0.5f).x / made.share(1.0f).x), more, 0.02);
        EXPECT_NEAR(1.0 + double(made.convex_m.x) / (10.0 * spread), convex, 0.02);
    }
}

TEST(ProfileCorrections, AreNoneWhereTheAlbedoIsNotKnown) {
    EXPECT_EQ(profile_corrections(glm::vec3(1.0f), glm::vec3(0.002f), kEta), ProfileCorrections{});
}

}  // namespace
}  // namespace tyndall::physics
