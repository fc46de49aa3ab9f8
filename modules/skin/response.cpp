#include "response.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec4.hpp>
#include <numbers>

namespace tyndall::skin {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kCurvatureMiddle = 100.0f;  // render/shaders/gbuffer.glsl
constexpr float kLeastChord_m = 1e-6f;

float cosine_of(int column) {
    return 2.0f * float(column) / float(Response::kCosines - 1) - 1.0f;
}

template <class Value>
Response filled(const Value& value) {
    Response response;
    for (int y = 0; y < Response::kCurvatures; ++y)
        for (int x = 0; x < Response::kCosines; ++x)
            response.texels[size_t(y) * Response::kCosines + size_t(x)] = glm::vec4(value(y, cosine_of(x)), 0.0f);
    return response;
}

/// The clamped cosine's mean over the circle at angle `alpha` around a point of a sphere whose normal has this cosine
/// to the light, times 2 pi: the integral of max(a + b cos phi, 0).
float light_on_circle(float cosine, float alpha) {
    const float a = cosine * std::cos(alpha);
    const float b = std::sqrt(std::max(1.0f - cosine * cosine, 0.0f)) * std::sin(alpha);
    if (a >= b) return 2.0f * kPi * a;
    if (a <= -b) return 0.0f;
    const float half = std::acos(std::clamp(-a / b, -1.0f, 1.0f));  // lit for |phi| below
    return 2.0f * (a * half + b * std::sin(half));
}

/// Steps over the sphere around a point: angles, and the profile times area there, which sums to 1.
struct Circles {
    std::vector<float> angles;
    std::vector<glm::vec3> shares;

    Circles(const physics::DiffusionProfile& profile, float curvature) {
        constexpr int kSteps = 240;
        const float radius = 1.0f / std::max(curvature, 1e-3f);
        // chords from a micrometre to the whole sphere, or as far as light gets
        const float farthest = std::min(2.0f * radius, 8.0f * std::sqrt(profile.lobes.back().variance_m2));
        const float first = std::min(kLeastChord_m, 0.001f * farthest);
        glm::vec3 total(0.0f);
        float low = 0.0f;
        for (int i = 0; i <= kSteps; ++i) {
            const float high = first * std::pow(farthest / first, float(i) / kSteps);
            // rings of a sphere have the area of the flat ones between the same chords
            const glm::vec3 share = profile.within(high) - profile.within(low);
            angles.push_back(2.0f * std::asin(std::min(0.25f * (low + high) / radius, 1.0f)));
            shares.push_back(share);
            total += share;
            low = high;
        }
        for (glm::vec3& share : shares) share /= glm::max(total, glm::vec3(1e-12f));
    }
};

}  // namespace

float Response::curvature_of(int row) {
    const float t = std::min(float(row) / float(kCurvatures - 1), 0.98f);
    return kCurvatureMiddle * t / (1.0f - t);
}

Response lambert_response() {
    return filled([](int, float cosine) { return glm::vec3(std::max(cosine, 0.0f)); });
}

Response wrap_response(const physics::DiffusionProfile& profile) {
    return filled([&](int row, float cosine) {
        const float curvature = Response::curvature_of(row);
        const glm::vec3 moment = 1.0f - 0.5f * profile.mean_square() * curvature * curvature;
        glm::vec3 light;
        for (int c = 0; c < 3; ++c) {
            const float a = std::min(3.0f / std::max(moment[c], 0.75f) - 3.0f, 1.0f);
            const float above = std::max(cosine + a, 0.0f) / (1.0f + a);
            light[c] = std::pow(above, 1.0f + a) * (2.0f + a) / (2.0f * (1.0f + a));
        }
        return light;
    });
}

Response preintegrated_response(const physics::DiffusionProfile& profile) {
    std::vector<Circles> circles;
    for (int row = 0; row < Response::kCurvatures; ++row) circles.emplace_back(profile, Response::curvature_of(row));
    return filled([&](int row, float cosine) {
        const Circles& around = circles[size_t(row)];
        glm::vec3 light(0.0f);
        for (size_t i = 0; i < around.angles.size(); ++i)
            light += around.shares[i] * light_on_circle(cosine, around.angles[i]);
        return light / (2.0f * kPi);
    });
}

Response corrected(const Response& response, const physics::ProfileCorrections& corrections) {
    constexpr float kMost = 0.5f;  // of the radius: so far the fits hold
    return filled([&](int row, float cosine) {
        const auto at = [&](float c, int channel) {
            const float x = 0.5f * (c + 1.0f) * float(Response::kCosines - 1);
            const int left = std::clamp(int(x), 0, Response::kCosines - 2);
            const size_t first = size_t(row * Response::kCosines + left);
            return std::lerp(response.texels[first][channel], response.texels[first + 1][channel], x - float(left));
        };
        const float angle = std::acos(cosine);
        const float curvature = Response::curvature_of(row);
        const glm::vec3 convex = 1.0f + glm::min(corrections.convex_m * curvature, kMost);
        glm::vec3 light;
        for (int c = 0; c < 3; ++c) {
            const float drift = std::min(corrections.drift_m[c] * curvature, kMost);
            float entered = angle;  // angle = entered + drift sin(entered)
            for (int i = 0; i < 12; ++i) entered = angle - drift * std::sin(entered);
            const float from = std::cos(entered);
            // rings of the sphere are wider where light comes to than where it comes from
            const float narrower = angle > 1e-3f && angle < kPi - 1e-3f ? std::sin(entered) / std::sin(angle)
                                                                        : 1.0f / (1.0f + drift * cosine);
            light[c] = at(from, c) * corrections.share(std::max(from, 0.0f))[c] * narrower / (1.0f + drift * from);
        }
        return light * convex;
    });
}

ShadowResponse shadow_response(const physics::DiffusionProfile& profile) {
    ShadowResponse response;
    for (int y = 0; y < ShadowResponse::kWidths; ++y) {
        const float half = 0.5f * ShadowResponse::kWidest_m * float(y) / float(ShadowResponse::kWidths - 1);
        const glm::vec3 low = profile.edge(-half);
        const glm::vec3 span = profile.edge(half) - low;
        for (int x = 0; x < ShadowResponse::kShares; ++x) {
            const float share = float(x) / float(ShadowResponse::kShares - 1);
            const glm::vec3 light =
                half > 0.0f ? (profile.edge((2.0f * share - 1.0f) * half) - low) / span : glm::vec3(share);
            response.texels[size_t(y) * ShadowResponse::kShares + size_t(x)] = glm::vec4(light, 0.0f);
        }
    }
    return response;
}

}  // namespace tyndall::skin
