#include "scatter_maps/scatter_block.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "interior_block.h"
#include "phase_table.h"
#include "physics/physics.h"

namespace tyndall::translucency {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
/// The first ring lies so many mean free paths or texels around the pixel.
constexpr float kFirstPaths = 0.3f, kFirstTexels = 1.5f;
/// Light that leaves so many mean free paths from where it entered has forgotten where that was (as in points).
constexpr float kDeepPaths = 4.0f;
/// How many mean free paths form hery looks into the solid.
constexpr float kHeryPaths = 3.0f;

using Block = ScatterBlock;

/// Shares of what enters, by the cosine inside.
void add_shares(ScatterTables& tables, const ScatterKey& key, const Optics& optics) {
    const bool exact = key.scaling == Scaling::exact;
    const physics::HalfSpace body(exact ? body_albedo(optics, key.body_radius) : optics.albedo(), optics.eta);
    for (int i = 0; i < Block::kCosines; ++i) {
        const float cosine = static_cast<float>(i) / (Block::kCosines - 1);
        const bool apart = key.settings.form != ScatterMapsForm::green;  // green has no march for it
        const glm::vec3 once = apart ? single_share(key.interior, std::max(cosine, 1e-3f)) : glm::vec3(0.0f);
        tables.cosines[ScatterTables::multiple][size_t(i)] =
            glm::vec4(exact ? glm::max(body.table()[size_t(i)] - once, glm::vec3(0.0f)) : glm::vec3(1.0f), 0.0f);
        tables.cosines[ScatterTables::near][size_t(i)] = glm::vec4(
            exact ? body.table()[size_t(i)] / glm::max(body.diffuse_leaving(), glm::vec3(1e-6f)) : glm::vec3(1.0f),
            0.0f);
        tables.cosines[ScatterTables::deep][size_t(i)] =
            glm::vec4(exact ? body.deep()[size_t(i)] : glm::vec3(1.0f), 0.0f);
    }
}

/// Where the eye's ray is looked at. ki: each place stands for the same share of what the mean channel lets through;
/// hery: even steps.
void add_steps(Block& block, const ScatterKey& key) {
    const glm::vec3 sigma_s = key.interior.sigma_s_per_m;
    const glm::vec3 sigma_t = glm::max(sigma_s + key.interior.sigma_a_per_m, glm::vec3(1e-6f));
    const float guide = (sigma_t.x + sigma_t.y + sigma_t.z) / 3.0f;
    const bool hery = key.settings.form == ScatterMapsForm::hery;
    const int count = hery ? std::max(key.settings.steps / 2, 1) : key.settings.steps;
    const float longest = hery ? std::min(kHeryPaths / guide, 2.0f * key.extent) : 3.4f * key.extent;
    const float share = -std::expm1(-guide * longest);
    const auto place = [&](float i) {
        const float part = i / static_cast<float>(count);
        return hery ? longest * part : -std::log1p(-std::min(share * part, 0.999999f)) / guide;
    };
    for (int i = 0; i < count; ++i) {
        const float first = place(float(i)), last = i + 1 == count ? longest : place(float(i + 1));
        const float middle = place(float(i) + 0.5f);
        const glm::vec3 passed = (glm::exp(-sigma_t * first) - glm::exp(-sigma_t * last)) / sigma_t;
        block.steps[i] = glm::vec4(middle, std::min(last - first, 2.0f * (middle - first)), 0.0f, 0.0f);
        block.step_weights[i] = glm::vec4(sigma_s * passed, 0.0f);
    }
}

/// A kernel of diffusion.
struct Kernel {
    const ScatterKey& key;
    const Optics optics;
    const RadialKernel radial;
    const glm::vec3 scale;

    explicit Kernel(const ScatterKey& from, float first_ring)
        : key(from),
          optics(optics_of(from.interior)),
          radial(optics, from.model, from.scaling, first_ring),
          scale(from.scaling == Scaling::exact ? 1.0f / glm::max(radial.returned(), glm::vec3(1e-12f))
                                               : glm::vec3(1.0f)) {}
    [[nodiscard]] glm::vec3 at(float r) const { return scale * exitance(key.model, optics, r); }
    [[nodiscard]] glm::vec3 within(float r) const {
        return radial.share_within(r) * (key.scaling == Scaling::exact ? glm::vec3(1.0f) : radial.returned());
    }
};

/// Where in a ring the kernel is what it is on average: of the channels together.
float mean_radius(const Kernel& kernel, float inner, float outer, float area) {
    const glm::vec3 wanted = glm::max((kernel.within(outer) - kernel.within(inner)) / area, glm::vec3(1e-30f));
    float low = inner, high = outer;
    for (int i = 0; i < 30; ++i) {
        const float middle = 0.5f * (low + high);
        const glm::vec3 over = kernel.at(middle) / wanted;
        (over.x + over.y + over.z > 3.0f ? low : high) = middle;
    }
    return 0.5f * (low + high);
}

void add_taps(Block& block, const Kernel& kernel, float first_ring, float last_ring) {
    const float widening = std::pow(last_ring / first_ring, 1.0f / Block::kRings);
    float inner = first_ring;
    for (int ring = 0; ring < Block::kRings; ++ring, inner *= widening) {
        const float area = kPi * inner * inner * (widening * widening - 1.0f);
        const float radius = mean_radius(kernel, inner, inner * widening, area), tap = area / Block::kRingTaps;
        for (int i = 0; i < Block::kRingTaps; ++i) {
            const float angle =
                2.0f * kPi * (static_cast<float>(i) + 0.5f * static_cast<float>(ring & 1)) / Block::kRingTaps;
            block.taps[ring * Block::kRingTaps + i] =
                glm::vec4(radius * std::cos(angle), radius * std::sin(angle), 0.5f * std::log2(tap), tap);
        }
    }
}

/// A disc of the map is an ellipse on a surface that the light grazes.
void add_own(ScatterTables& tables, const Kernel& kernel, float first_ring) {
    constexpr int kAngles = 32;
    for (int i = 0; i < Block::kCosines; ++i) {
        const float cosine = std::max(static_cast<float>(i) / (Block::kCosines - 1), 0.02f);
        glm::vec3 sum(0.0f);
        for (int a = 0; a < kAngles; ++a) {
            const float angle = 0.5f * kPi * (static_cast<float>(a) + 0.5f) / kAngles;
            sum += kernel.within(first_ring / std::hypot(std::cos(angle) * cosine, std::sin(angle)));
        }
        tables.cosines[ScatterTables::own][size_t(i)] = glm::vec4(sum / static_cast<float>(kAngles), 0.0f);
    }
}

/// What the rings give at a place of ground that faces the light, of a unit that enters each square metre of ground so
/// many metres behind.
glm::vec3 rings_over(const ScatterTables& tables, float behind_m) {
    glm::vec3 sum(0.0f);
    for (const glm::vec4& tap : tables.block.taps) {
        const float r2 = tap.x * tap.x + tap.y * tap.y + behind_m * behind_m;
        const float at = (tables.block.columns.x + tables.block.columns.y * std::log2(r2)) * ScatterTables::kColumns;
        const float column = std::clamp(at - 0.5f, 0.0f, float(ScatterTables::kColumns) - 1.001f);
        const auto i = size_t(column);
        sum += tap.w * glm::vec3(glm::mix(tables.kernel[0][i], tables.kernel[0][i + 1], column - float(i)));
    }
    return sum;
}

/// What is left of light that enters a wall so thick, which leaves on both sides. Thin walls, by the kernel: on each
/// side as much as of thick ground; a ball of the body's size counts as thick.
glm::vec3 left_by_kernel(const ScatterTables& tables, const Kernel& kernel, float metres) {
    const glm::vec3 body = glm::max(glm::vec3(tables.block.body), glm::vec3(1e-6f));
    const glm::vec3 beyond = glm::max(body - kernel.within(metres), glm::vec3(0.0f));
    return 1.0f / (body + beyond * (2.0f - body) / body);
}

/// The same, so that an endless wall sends out no more than has entered: rings are a coarse integral, and a kernel that
/// is whole on a ball gives a wall too much.
glm::vec3 left_of_wall(const ScatterTables& tables, const Kernel& kernel, float metres) {
    const glm::vec3 body = glm::max(glm::vec3(tables.block.body), glm::vec3(1e-6f));
    const glm::vec3 own(tables.cosines[ScatterTables::own].back());
    const glm::vec3 rings = rings_over(tables, 0.0f) + rings_over(tables, metres);
    return glm::min(left_by_kernel(tables, kernel, metres), (1.0f - own / body) / glm::max(rings, glm::vec3(1e-6f)));
}

/// 0 where it may be a wall, 1 where it is none. A body that is a wall is two thirds of its radius (3 volume over
/// surface) thick, a part of another less; a ball is thicker for most of its light.
float is_thick(const ScatterKey& key, float metres) {
    return glm::smoothstep(0.67f * key.body_radius, key.body_radius, metres);
}

/// What the light of a ball's thick part is multiplied by, so that the ball sends out as much as by the kernel.
glm::vec3 made_up(const ScatterTables& tables, const ScatterKey& key, const Kernel& kernel) {
    constexpr int kPlaces = 128;
    glm::vec3 lost(0.0f), thick(0.0f);
    for (int i = 0; i < kPlaces; ++i) {  // of equal light
        const float metres = 2.0f * key.body_radius * std::sqrt((float(i) + 0.5f) / kPlaces);
        const glm::vec3 all = left_by_kernel(tables, kernel, metres);
        lost += (1.0f - is_thick(key, metres)) * (all - left_of_wall(tables, kernel, metres));
        thick += is_thick(key, metres) * all;
    }
    return 1.0f + lost / glm::max(thick, glm::vec3(1e-6f));
}

void add_walls(ScatterTables& tables, const ScatterKey& key, const Kernel& kernel, float low, float high) {
    constexpr int kLast = ScatterTables::kColumns - 1;
    const bool exact = key.scaling == Scaling::exact;
    const glm::vec3 up = exact ? made_up(tables, key, kernel) : glm::vec3(1.0f);
    const auto left = [&](int i) {  // thinner walls look into the first column
        const float r2 = std::exp2(low + (high - low) * float(std::min(i, kLast)) / kLast);
        const float metres = i <= 0 ? 0.0f : std::sqrt(r2);
        const glm::vec3 all = left_by_kernel(tables, kernel, metres);
        if (!exact) return all;
        return glm::mix(left_of_wall(tables, kernel, metres), up * all, is_thick(key, metres));
    };
    for (int i = 0; i <= kLast; ++i)  // the least near by, for what is looked up between two columns
        tables.kernel[1].emplace_back(glm::min(left(i), glm::min(left(i - 1), left(i + 1))), 0.0f);
}

/// What form green sends through: as much as the kernel puts on the far half of a ball, twice since it is spread over
/// all of it. A closed body shows the light a quarter of its surface on average (Cauchy); with that, and the mean of
/// what has faded on a ball, all that leaves is as much as in the other forms.
void add_green(Block& block, const Kernel& kernel, const glm::vec3& reduced) {
    constexpr int kPlaces = 64;
    const float radius = kernel.key.body_radius;
    const glm::vec3 decay = glm::sqrt(3.0f * kernel.optics.sigma_a * reduced);
    const glm::vec3 all = glm::max(kernel.within(2.0f * radius), glm::vec3(1e-6f));
    const glm::vec3 beyond = 1.0f - kernel.within(std::numbers::sqrt2_v<float> * radius) / all;
    const float share = std::clamp(2.0f * (beyond.x + beyond.y + beyond.z) / 3.0f, 0.0f, 1.0f);
    glm::vec3 left(0.0f);
    for (int i = 0; i < kPlaces; ++i) {
        const glm::vec3 depth = decay * (2.0f * radius * (static_cast<float>(i) + 0.5f) / kPlaces);
        left += kernel.key.settings.falloff == ScatterMapsFalloff::ramp ? glm::max(1.0f - 0.5f * depth, glm::vec3(0.0f))
                                                                        : glm::exp(-depth);
    }
    block.green = glm::vec4(decay, share);
    block.green_amount = glm::vec4(0.25f * share * 2.0f / (1.0f + left / float(kPlaces)), 0.0f);
}

}  // namespace

bool same(const ScatterKey& a, const ScatterKey& b) {
    const ScatteringInterior &x = a.interior, &y = b.interior;
    return x.sigma_s_per_m == y.sigma_s_per_m && x.sigma_a_per_m == y.sigma_a_per_m && x.eta == y.eta &&
           x.phase.kind == y.phase.kind && x.phase.parameters == y.phase.parameters && x.phase.table == y.phase.table &&
           a.model == b.model && a.scaling == b.scaling && a.body_radius == b.body_radius && a.extent == b.extent &&
           a.settings.form == b.settings.form && a.settings.steps == b.settings.steps &&
           a.settings.map_size == b.settings.map_size && a.settings.light == b.settings.light &&
           a.settings.falloff == b.settings.falloff;
}

glm::vec3 single_share(const ScatteringInterior& interior, float cosine_inside) {
    constexpr int kCosines = 48, kAngles = 24, kPhases = 512;
    const std::vector<glm::vec4> phase = phase_row(interior.phase, kPhases);
    const float sine_in = std::sqrt(std::max(1.0f - cosine_inside * cosine_inside, 0.0f));
    glm::vec3 sum(0.0f);
    for (int i = 0; i < kCosines; ++i) {
        const float out = (static_cast<float>(i) + 0.5f) / kCosines, sine_out = std::sqrt(1.0f - out * out);
        const float leaves = interior.eta > 1.0f ? 1.0f - physics::fresnel_dielectric(out, 1.0f / interior.eta) : 1.0f;
        glm::vec3 mean(0.0f);
        for (int a = 0; a < kAngles; ++a) {
            const float angle = kPi * (static_cast<float>(a) + 0.5f) / kAngles;
            const float u = std::clamp(sine_in * sine_out * std::cos(angle) - cosine_inside * out, -1.0f, 1.0f);
            mean += glm::vec3(phase[size_t(std::acos(u) / kPi * (kPhases - 1) + 0.5f)]);
        }
        sum += mean / static_cast<float>(kAngles) * (leaves * out / (cosine_inside + out));
    }
    const glm::vec3 sigma_t = glm::max(interior.sigma_s_per_m + interior.sigma_a_per_m, glm::vec3(1e-6f));
    return interior.sigma_s_per_m / sigma_t * sum * (2.0f * kPi / kCosines);
}

ScatterTables scatter_tables(const ScatterKey& key) {
    ScatterTables tables;
    Block& block = tables.block;
    const Optics optics = optics_of(key.interior);
    const glm::vec3 reduced = glm::max(optics.sigma_s_reduced + optics.sigma_a, glm::vec3(1e-6f));
    const float shortest = 1.0f / std::max({reduced.x, reduced.y, reduced.z});
    const float texel = 2.0f * key.extent / static_cast<float>(key.settings.map_size);
    const float last_ring = 1.8f * key.extent;
    const float first_ring = std::clamp(kFirstPaths * shortest, kFirstTexels * texel, 0.2f * last_ring);
    tables.first_ring = first_ring;
    const Kernel kernel(key, first_ring);
    block.extinction = glm::vec4(key.interior.sigma_s_per_m + key.interior.sigma_a_per_m, key.interior.eta);
    add_steps(block, key);
    add_shares(tables, key, optics);
    add_own(tables, kernel, first_ring);
    add_taps(block, kernel, first_ring, last_ring);
    block.body = glm::vec4(key.scaling == Scaling::exact ? kernel.within(2.0f * key.body_radius) : glm::vec3(1.0f),
                           key.body_radius);
    const float low = 2.0f * std::log2(0.25f * first_ring), high = 2.0f * std::log2(4.0f * last_ring);
    const float path = 3.0f / (reduced.x + reduced.y + reduced.z);
    block.columns = glm::vec4((0.5f - low * (ScatterTables::kColumns - 1) / (high - low)) / ScatterTables::kColumns,
                              (ScatterTables::kColumns - 1) / (high - low) / ScatterTables::kColumns, 0.0f, 0.0f);
    for (int i = 0; i < ScatterTables::kColumns; ++i) {
        const float r = std::exp2(0.5f * (low + (high - low) * static_cast<float>(i) / (ScatterTables::kColumns - 1)));
        tables.kernel[0].emplace_back(kernel.at(r),
                                      1.0f - std::exp2(-r / (kDeepPaths * path) * std::numbers::log2e_v<float>));
    }
    add_walls(tables, key, kernel, low, high);
    add_green(block, kernel, reduced);
    return tables;
}

}  // namespace tyndall::translucency
