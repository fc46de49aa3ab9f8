#include "physics/tables.h"
#include "physics_test.h"

namespace tyndall::physics {
namespace {

const SpecularTable& table() {
    static const SpecularTable made = make_specular_table();
    return made;
}

vec3 view_at(float nov) {
    return {std::sqrt(1 - nov * nov), 0, nov};
}

/// `standard_light` integrated over all directions of unit radiance: lobe samples for the specular sums, the exact pi
/// for the diffuse one.
LightTerms furnace_terms(float nov, float roughness) {
    constexpr unsigned kSamples = 4096;
    const vec3 n(0, 0, 1), v = view_at(nov);
    const float alpha = ggx_alpha(roughness);
    dvec3 a(0), b(0);
    for (unsigned i = 0; i < kSamples; ++i) {
        const vec2 xi = hammersley(i, kSamples) + 0.5f / float(kSamples);
        const vec3 h = sample_ggx_visible_normal(vec2(min(xi.x, 0.99999f), xi.y), v, alpha);
        const vec3 l = normalize(2.0f * dot(v, h) * h - v);
        if (l.z <= 0) continue;
        const LightTerms terms = standard_light(n, v, l, roughness, vec3(1));
        const double pdf = double(ggx_reflection_pdf(n, v, normalize(l + v), alpha));
        a += dvec3(terms.specular_a) / pdf;
        b += dvec3(terms.specular_b) / pdf;
    }
    LightTerms sum = no_light();
    sum.diffuse = vec3(kPi);
    sum.specular_a = vec3(a / double(kSamples));
    sum.specular_b = vec3(b / double(kSamples));
    return sum;
}

void furnace(const char* name, const StandardMaterial& material) {
    float low = 2, high = 0;
    for (float roughness = 0.05f; roughness <= 1.0001f; roughness += 0.0475f) {
        for (float nov = 0.05f; nov <= 1.0001f; nov += 0.0475f) {
            const float cosine = min(nov, 1.0f), rough = min(roughness, 1.0f);
            const vec3 out = standard_compose(material, table().sample(cosine, rough), furnace_terms(cosine, rough));
            EXPECT_GE(out.x, 0.97f) << name << " roughness " << rough << " NoV " << cosine;
            EXPECT_LE(out.x, 1.0f + 1e-6f) << name << " roughness " << rough << " NoV " << cosine;
            low = min(low, out.x);
            high = max(high, out.x);
        }
    }
    measured((std::string("white furnace, ") + name + ", lowest").c_str(), double(low));
    measured((std::string("white furnace, ") + name + ", 1 - highest").c_str(), 1.0 - double(high));
}

TEST(WhiteFurnace, Dielectric) {
    furnace("dielectric", standard_material(vec3(1), 0, 1.5f, 1, vec3(1)));
}
TEST(WhiteFurnace, Metal) {
    furnace("metal", standard_material(vec3(1), 1, 1.5f, 1, vec3(1)));
}
TEST(WhiteFurnace, HalfMetal) {
    furnace("half metal", standard_material(vec3(1), 0.5f, 1.5f, 1, vec3(1)));
}
TEST(WhiteFurnace, NoSpecular) {
    furnace("no specular", standard_material(vec3(1), 0, 1.5f, 0, vec3(1)));
}
TEST(WhiteFurnace, Diamond) {
    furnace("diamond", standard_material(vec3(1), 0, 2.42f, 1, vec3(1)));
}

TEST(WhiteFurnace, ProbeIsWhiteToo) {
    const StandardMaterial material = standard_material(vec3(1), 0, 1.5f, 1, vec3(1));
    for (const float roughness : {0.05f, 0.33f, 1.0f}) {
        const vec2 t = table().sample(0.4f, roughness);
        EXPECT_NEAR(standard_compose(material, t, standard_environment(vec3(kPi), vec3(1), t)).x, 1.0f, 1e-5f);
    }
}

TEST(SpecularTable, AgreesWithFineQuadrature) {
    double worst = 0, highest = 0;
    Random random(9);
    for (int i = 0; i < 300; ++i) {
        const float nov = random.between(0.05f, 1), roughness = random.between(0.05f, 1);
        const vec2 difference = table().sample(nov, roughness) - ggx_directional_albedo(nov, roughness, 160);
        worst = std::max({worst, std::abs(double(difference.x)), std::abs(double(difference.y))});
        highest = std::max(highest, -double(difference.x + difference.y));
    }
    EXPECT_LT(worst, 0.01);
    measured("specular table, worst absolute error", worst);
    measured("specular table, most that it lies below", highest);
}

TEST(Ggx, DistributionIsNormalised) {
    for (const float roughness : {0.05f, 0.2f, 0.6f, 1.0f}) {
        const float alpha = ggx_alpha(roughness);
        const auto f = [&](double x) {  // theta = x^2 crowds the cells at the peak
            const double theta = x * x;
            const vec3 h(float(std::sin(theta)), 0, float(std::cos(theta)));
            return double(ggx_distribution(vec3(0, 0, 1), h, alpha)) * std::cos(theta) * std::sin(theta) * 2 * x;
        };
        EXPECT_NEAR(2 * 3.14159265358979 * integrate(f, 0, std::sqrt(0.5 * 3.14159265358979), 4000), 1, 2e-5);
    }
}

TEST(Ggx, VisibleNormalsHaveTheDensity) {
    constexpr int kTheta = 16, kPhi = 16, kSamples = 200000;
    double worst = -100;
    for (const float roughness : {0.3f, 0.7f, 1.0f}) {
        for (const float nov : {0.1f, 0.6f, 1.0f}) {
            const vec3 n(0, 0, 1), v = view_at(nov);
            const float alpha = ggx_alpha(roughness);
            Random random(23);
            std::vector<double> counts(kTheta * kPhi), expected(kTheta * kPhi);
            for (int i = 0; i < kSamples; ++i) {
                const vec3 h = sample_ggx_visible_normal(random.pair(), v, alpha);
                const float phi = std::atan2(h.y, h.x) / kTwoPi + 0.5f;
                const int x = std::min(int(h.z * kTheta), kTheta - 1), y = std::min(int(phi * kPhi), kPhi - 1);
                ++counts[size_t(y * kTheta + x)];
            }
            constexpr int kSubZ = 200, kSubPhi = 8;
            for (int i = 0; i < kTheta * kSubZ; ++i) {
                for (int j = 0; j < kPhi * kSubPhi; ++j) {
                    const float z = (float(i) + 0.5f) / (kTheta * kSubZ);
                    const vec3 h = spherical_direction(z, kTwoPi * ((float(j) + 0.5f) / (kPhi * kSubPhi) - 0.5f));
                    const float voh = max(dot(v, h), 0.0f);  // D_v = 4 VoH times the reflected density
                    expected[size_t(j / kSubPhi * kTheta + i / kSubZ)] +=
                        double(4 * voh * ggx_reflection_pdf(n, v, h, alpha)) * kSamples * 2 * 3.14159265358979 /
                        (kTheta * kSubZ * kPhi * kSubPhi);
                }
            }
            const double excess = chi_square_excess(counts, expected);
            EXPECT_LT(excess, 4.0) << roughness << ' ' << nov;
            worst = std::max(worst, excess);
        }
    }
    measured("visible normals, worst chi-square excess (sigma)", worst);
}

TEST(Standard, IsLinearInLightAndSplitsFresnel) {
    const vec3 n(0, 0, 1), v = view_at(0.7f), l = normalize(vec3(-0.3f, 0.4f, 0.6f));
    const LightTerms one = standard_light(n, v, l, 0.4f, vec3(1)), three = standard_light(n, v, l, 0.4f, vec3(3));
    EXPECT_NEAR(three.specular_a.x, 3 * one.specular_a.x, 1e-6f * three.specular_a.x);
    const vec3 h = normalize(l + v);
    const vec3 f0(0.1f, 0.5f, 0.9f), split = f0 * one.specular_a + one.specular_b;
    const float alpha = ggx_alpha(0.4f);
    const vec3 whole = fresnel_schlick(f0, vec3(1), dot(v, h)) *
                       (ggx_distribution(n, h, alpha) * ggx_visibility(l.z, 0.7f, alpha) * l.z);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(split[k], whole[k], 1e-5f * whole[k]);
    EXPECT_EQ(standard_light(n, v, -l, 0.4f, vec3(1)).diffuse, vec3(0));
}

TEST(Fresnel, DielectricIsRight) {
    EXPECT_NEAR(fresnel_dielectric(1, 1.5f), 0.04f, 1e-6f);
    EXPECT_NEAR(f0_from_eta(1 / 1.5f), 0.04f, 1e-6f);
    EXPECT_NEAR(fresnel_dielectric(std::cos(std::atan(1.5f)), 1.5f), 0.5f * square(0.3846154f), 1e-5f);  // Brewster
    EXPECT_EQ(fresnel_dielectric(0.5f, 1 / 1.5f), 1.0f);                                                 // total
    for (float c = 0.05f; c <= 1; c += 0.05f) {
        EXPECT_NEAR(fresnel_conductor(c, vec3(1.5f), vec3(0)).x, fresnel_dielectric(c, 1.5f), 1e-5f);
        vec3 t;
        ASSERT_TRUE(refract_ray(vec3(std::sqrt(1 - c * c), 0, -c), vec3(0, 0, 1), 1 / 1.5f, t));
        EXPECT_NEAR(t.x * 1.5f, std::sqrt(1 - c * c), 1e-6f);
        EXPECT_NEAR(fresnel_dielectric(-t.z, 1 / 1.5f), fresnel_dielectric(c, 1.5f), 2e-5f);  // both ways alike
    }
    vec3 t;
    EXPECT_FALSE(refract_ray(normalize(vec3(1, 0, -0.5f)), vec3(0, 0, 1), 1.5f, t));
}

TEST(Fresnel, DiffuseReflectanceNearItsIntegral) {
    double worst = 0;
    for (const float eta : {0.66f, 0.75f, 0.9f, 1.1f, 1.3f, 1.5f, 1.8f, 2.0f}) {
        // light inside a medium of index eta meets the outside: n_beyond / n_here = 1 / eta
        const auto f = [&](double c) { return 2 * c * double(fresnel_dielectric(float(c), 1 / eta)); };
        worst = std::max(worst, std::abs(double(fresnel_diffuse_reflectance(eta)) - integrate(f, 0, 1, 4000)));
    }
    EXPECT_LT(worst, 0.002);
    measured("Fdr polynomial, worst absolute error for eta 0.66..2", worst);
}

}  // namespace
}  // namespace tyndall::physics
