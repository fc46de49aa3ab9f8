#include "physics_test.h"

namespace tyndall::physics {
namespace {

using Inside = std::function<bool(dvec3)>;
using Clip = std::function<bool(vec3, vec3, float&, float&)>;

/// Walks the ray in small steps and compares what is inside with the interval that `clip` gives.
void compare_with_walk(const char* what, vec3 origin, vec3 direction, const Inside& inside, const Clip& clip) {
    constexpr int kSteps = 4000;
    const float begin = 0.0f, end = 40.0f;
    const double step = double(end - begin) / kSteps;
    double first = -1, last = -1;
    for (int i = 0; i <= kSteps; ++i) {
        const double t = double(begin) + i * step;
        if (!inside(dvec3(origin) + t * dvec3(direction))) continue;
        if (first < 0) first = t;
        last = t;
    }
    float t0 = begin, t1 = end;
    const bool hit = clip(origin, direction, t0, t1);
    ASSERT_EQ(t0 != t0 || t1 != t1, false) << what;
    if (first >= 0 && last > first) {
        ASSERT_TRUE(hit) << what << ": a walk is inside from " << first << " to " << last;
        EXPECT_NEAR(double(t0), first, 1.5 * step) << what;
        EXPECT_NEAR(double(t1), last, 1.5 * step) << what;
    } else if (hit) {
        EXPECT_LT(double(t1 - t0), 2 * step) << what << ": a walk never is inside";
    }
}

/// A ray that starts within 12 m: at random, along an axis, or from exactly the point `special`.
std::pair<vec3, vec3> random_ray(Random& random, int i, vec3 special) {
    vec3 origin = 12.0f * random() * random.direction();
    vec3 direction = random.direction();
    if (i % 4 == 1) direction = normalize(special - origin + 0.5f * random.direction());
    if (i % 7 == 2) direction = vec3(i % 3 == 0, i % 3 == 1, i % 3 == 2) * (i % 2 ? 1.0f : -1.0f);
    if (i % 11 == 3) origin = special;
    return {origin, direction};
}

TEST(Intersect, BoxAgreesWithWalking) {
    Random random(1);
    for (int i = 0; i < 400; ++i) {
        const vec3 low = 3.0f * random.direction(), high = low + vec3(random(), random(), random()) * 5.0f + 0.1f;
        const auto [origin, direction] = random_ray(random, i, low);
        const auto inside = [&](dvec3 p) {
            return all(greaterThanEqual(p, dvec3(low))) && all(lessThanEqual(p, dvec3(high)));
        };
        compare_with_walk("box", origin, direction, inside,
                          [&](vec3 o, vec3 d, float& t0, float& t1) { return clip_to_box(o, d, low, high, t0, t1); });
    }
}

TEST(Intersect, SphereAgreesWithWalking) {
    Random random(2);
    for (int i = 0; i < 400; ++i) {
        const vec3 center = 5.0f * random.direction();
        const float radius = random.between(0.1f, 6);
        const auto [origin, direction] = random_ray(random, i, center);
        const auto inside = [&](dvec3 p) { return length(p - dvec3(center)) <= double(radius); };
        compare_with_walk("sphere", origin, direction, inside, [&](vec3 o, vec3 d, float& t0, float& t1) {
            return clip_to_sphere(o, d, center, radius, t0, t1);
        });
    }
}

TEST(Intersect, ConeAgreesWithWalking) {
    Random random(3);
    for (int i = 0; i < 1500; ++i) {
        const vec3 apex = 4.0f * random.direction();
        const vec3 axis = i % 5 == 0 ? vec3(0, -1, 0) : random.direction();
        const float angle = random.between(0.02f, 1.45f), range = random.between(1, 20);
        const float cosine = std::cos(angle);
        auto [origin, direction] = random_ray(random, i, apex);
        if (i % 13 == 4) direction = i % 2 ? axis : -axis;  // along the axis
        if (i % 13 == 5 &&
            i % 11 != 3) {  // parallel to the side; from the apex, inside or outside is a matter of rounding
            direction = direction_about(axis, i % 2 ? cosine : -cosine, random());
        }
        const auto inside = [&](dvec3 p) {
            const dvec3 x = p - dvec3(apex);
            return length(x) <= double(range) && dot(x, dvec3(axis)) >= double(cosine) * length(x);
        };
        compare_with_walk(("cone " + std::to_string(i)).c_str(), origin, direction, inside,
                          [&](vec3 o, vec3 d, float& t0, float& t1) {
                              return clip_to_cone(o, d, apex, axis, cosine, range, t0, t1);
                          });
    }
}

TEST(Intersect, ConeFromFarAway) {
    // A narrow spot 20 m wide seen from 2 km: the float32 interval must stay within centimetres.
    const vec3 apex(0, 30, 0), axis(0, -1, 0), origin(-2000, 10, 3), direction = vec3(1, 0, 0);
    const float cosine = std::cos(0.35f);
    float t0 = 0, t1 = 1e4f;
    ASSERT_TRUE(clip_to_cone(origin, direction, apex, axis, cosine, 40, t0, t1));
    const double half = std::sqrt(std::pow(20 * std::tan(0.35), 2) - 9);
    EXPECT_NEAR(t0, 2000 - half, 2e-3);
    EXPECT_NEAR(t1, 2000 + half, 2e-3);
    measured("cone seen from 2 km, error of its near side (m)", std::abs(double(t0) - (2000 - half)));
}

TEST(Intersect, WideConeIsItsRange) {
    float t0 = 0, t1 = 100;
    ASSERT_TRUE(clip_to_cone(vec3(0, 0, -10), vec3(0, 0, 1), vec3(0), vec3(0, 0, 1), -0.2f, 4, t0, t1));
    EXPECT_NEAR(t0, 6, 1e-5);
    EXPECT_NEAR(t1, 14, 1e-5);
}

}  // namespace
}  // namespace tyndall::physics
