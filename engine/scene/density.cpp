#include "scene/density.h"

#include <algorithm>
#include <cmath>

#include "physics/physics.h"

namespace tyndall {
namespace {

// Alternatives of DensityField.
constexpr size_t kHeight = 1, kBlobs = 2, kNoise = 3, kGrid = 4, kGradient = 5, kProduct = 6;
static_assert(std::is_same_v<std::variant_alternative_t<kHeight, DensityField>, HeightDensity> &&
              std::is_same_v<std::variant_alternative_t<kBlobs, DensityField>, BlobDensity> &&
              std::is_same_v<std::variant_alternative_t<kNoise, DensityField>, NoiseDensity> &&
              std::is_same_v<std::variant_alternative_t<kGrid, DensityField>, GridDensity> &&
              std::is_same_v<std::variant_alternative_t<kGradient, DensityField>, GradientDensity> &&
              std::is_same_v<std::variant_alternative_t<kProduct, DensityField>, ProductDensity>);
// Evaluation rounds; a bound is this much above what exact arithmetic gives.
constexpr float kSlack = 1.0f + 1e-5f;
/// The greatest value of a kind of noise, and its steepest slope per cell.
struct NoiseLimits {
    float value, slope;
};
// Perlin's over every choice of gradients; Worley's from distances that are 0 at best and rise by 1 per cell.
constexpr NoiseLimits kPerlinLimits{1.04f, 3.9f};
const float kPuffScale = 0.27018512f / physics::kCellDistanceDeviation;
const NoiseLimits kWorleyLimits{physics::kCellDistanceMean * kPuffScale, kPuffScale};
constexpr double kLargestExponent = 80.0;  // e^80 is still a finite float

float finite(float value) {
    return value < std::numeric_limits<float>::max() ? std::max(value, 0.0f) : 0.0f;
}

int octaves_of(const NoiseDensity& noise) {
    return std::clamp(noise.octaves, 1, 16);
}

/// Half the extent of a local box along the axes of `map`'s target.
glm::vec3 mapped_half(const glm::mat4& map, const Bounds& local) {
    const glm::vec3 half = 0.5f * local.size();
    return glm::abs(glm::vec3(map[0])) * half.x + glm::abs(glm::vec3(map[1])) * half.y +
           glm::abs(glm::vec3(map[2])) * half.z;
}

}  // namespace

DensityEvaluator::DensityEvaluator(DensityField field, const glm::mat4& local_to_world, double time_s)
    : field_(std::move(field)) {
    if (const auto* height = std::get_if<HeightDensity>(&field_)) prepare_height(*height, local_to_world);
    if (const auto* blobs = std::get_if<BlobDensity>(&field_)) prepare_blobs(*blobs);
    if (const auto* noise = std::get_if<NoiseDensity>(&field_)) prepare_noise(*noise, local_to_world, time_s);
    if (const auto* grid = std::get_if<GridDensity>(&field_)) grid_.emplace(*grid);
    if (const auto* product = std::get_if<ProductDensity>(&field_)) prepare_product(*product, local_to_world, time_s);
}

void DensityEvaluator::prepare_height(const HeightDensity& height, const glm::mat4& local_to_world) {
    const double per_m = -1.0 / double(height.scale_height_m);
    exponent_slope_ = per_m * glm::dvec3(local_to_world[0].y, local_to_world[1].y, local_to_world[2].y);
    exponent_ = per_m * (double(local_to_world[3].y) - double(height.base_m));
}

void DensityEvaluator::prepare_blobs(const BlobDensity& density) {
    for (const BlobDensity::Blob& blob : density.blobs)
        if (blob.radius > 0.0f) blobs_.push_back({blob.centre, -0.5f / (blob.radius * blob.radius), blob.weight});
}

void DensityEvaluator::prepare_noise(const NoiseDensity& noise, const glm::mat4& local_to_world, double time_s) {
    const glm::dvec3 origin = glm::dvec3(local_to_world[3]) - glm::dvec3(noise.wind_m_s) * time_s;
    for (int axis = 0; axis < 3; ++axis)
        map_[axis] = glm::vec4(glm::vec3(local_to_world[axis]) / noise.feature_m, 0.0f);
    map_[3] = glm::vec4(glm::vec3(origin / double(noise.feature_m)), 1.0f);
    churn_ = float(double(noise.churn_per_s) * time_s);
}

void DensityEvaluator::prepare_product(const ProductDensity& product, const glm::mat4& local_to_world, double time_s) {
    factors_.emplace_back(*product.base, local_to_world, time_s);
    if (product.mask) factors_.emplace_back(*product.mask, local_to_world, time_s);
    if (product.layer) factors_.emplace_back(*product.layer, local_to_world, time_s);
}

float DensityEvaluator::at(const glm::vec3& local) const {
    switch (field_.index()) {
        case kHeight:
            return float(
                std::exp(std::min(exponent_ + glm::dot(exponent_slope_, glm::dvec3(local)), kLargestExponent)));
        case kBlobs:
            return blobs_at(local);
        case kNoise:
            return noise_at(local);
        case kGrid:
            return grid_->at(local);
        case kGradient:
            return gradient_at(local);
        case kProduct: {
            float product = 1.0f;
            for (const DensityEvaluator& factor : factors_) product *= factor.at(local);
            return finite(product);
        }
        default:
            return 1.0f;
    }
}

float DensityEvaluator::blobs_at(const glm::vec3& local) const {
    constexpr float kNothing = -40.0f;  // e^-40 is lost beside any sum that matters
    float sum = 0.0f;
    for (const PreparedBlob& blob : blobs_) {
        const glm::vec3 away = local - blob.centre;
        const float exponent = blob.exponent * glm::dot(away, away);
        if (exponent > kNothing) sum += blob.weight * std::exp(exponent);
    }
    return finite(sum);
}

float DensityEvaluator::noise_at(const glm::vec3& local) const {
    const auto& noise = *std::get_if<NoiseDensity>(&field_);
    glm::vec3 place(map_ * glm::vec4(local, 1.0f));
    if (noise.swirl != 0.0f) place += noise.swirl * physics::noise_swirl(place, churn_);
    return finite(physics::filtered_noise_density(place, int(noise.kind), octaves_of(noise), noise.coverage, 0.0f));
}

float DensityEvaluator::gradient_at(const glm::vec3& local) const {
    const auto& gradient = *std::get_if<GradientDensity>(&field_);
    const float at = gradient.radial ? physics::radial_ramp(local, gradient.from, gradient.inner, gradient.outer)
                                     : physics::linear_ramp(local, gradient.from, gradient.to);
    return finite(glm::mix(gradient.start, gradient.end, at));
}

float DensityEvaluator::upper_bound(const Bounds& local) const {
    if (local.empty()) return 0.0f;
    switch (field_.index()) {
        case kHeight: {
            const double middle = glm::dot(exponent_slope_, 0.5 * (glm::dvec3(local.low) + glm::dvec3(local.high)));
            const double half =
                glm::dot(glm::abs(exponent_slope_), 0.5 * (glm::dvec3(local.high) - glm::dvec3(local.low)));
            return kSlack * float(std::exp(std::min(exponent_ + middle + half, kLargestExponent)));
        }
        case kBlobs:
            return blobs_bound(local);
        case kNoise:
            return noise_bound(local);
        case kGrid:
            return grid_->upper_bound(local);
        case kGradient:
            return gradient_bound(local);
        case kProduct: {
            float product = kSlack;
            for (const DensityEvaluator& factor : factors_) product *= factor.upper_bound(local);
            return finite(product);
        }
        default:
            return 1.0f;
    }
}

float DensityEvaluator::blobs_bound(const Bounds& local) const {
    float sum = 0.0f;
    float size = 0.0f;
    for (const PreparedBlob& blob : blobs_) {
        const glm::vec3 nearest = glm::clamp(blob.centre, local.low, local.high) - blob.centre;
        const glm::vec3 farthest = glm::max(glm::abs(local.low - blob.centre), glm::abs(local.high - blob.centre));
        const glm::vec3 away = blob.weight >= 0.0f ? nearest : farthest;
        const float value = blob.weight * std::exp(blob.exponent * glm::dot(away, away));
        sum += value;
        size += std::abs(value);
    }
    return finite(sum + (kSlack - 1.0f) * size);
}

float DensityEvaluator::noise_bound(const Bounds& local) const {
    const auto& noise = *std::get_if<NoiseDensity>(&field_);
    if (noise.swirl != 0.0f) return 1.0f;  // what is looked up may come from anywhere near
    const NoiseLimits limits = noise.kind == NoiseKind::worley ? kWorleyLimits : kPerlinLimits;
    const int octaves = octaves_of(noise);
    const glm::vec3 centre = glm::vec3(map_ * glm::vec4(local.centre(), 1.0f));
    const float radius = glm::length(mapped_half(map_, local)) + 1e-6f * glm::length(centre);
    float sum = 0.0f, variance = 0.0f;
    for (int octave = 0; octave < octaves; ++octave) {
        const float size = std::ldexp(1.0f, -octave);
        const float rise = limits.slope * radius / size;
        const glm::vec3 place = physics::fractal_noise_place(centre, octave);
        const uint32_t seed = physics::hash_pcg(uint32_t(octave));
        float middle = limits.value;
        if (rise < 2.0f * limits.value)
            middle = noise.kind == NoiseKind::worley ? physics::cellular_noise(place, seed)
                                                     : physics::gradient_noise(place, seed);
        sum += size * std::min(middle + rise, limits.value);
        variance += size * size;
    }
    const float most = kSlack * sum / std::sqrt(variance * physics::kGradientNoiseVariance);
    return std::min(kSlack * physics::noise_to_density(most, noise.coverage) + 3e-5f / std::max(noise.coverage, 1e-4f),
                    1.0f);
}

float DensityEvaluator::gradient_bound(const Bounds& local) const {
    const auto& gradient = *std::get_if<GradientDensity>(&field_);
    // a ramp is monotonic along its line and away from its centre: its ends in a box are at the box's ends
    float low = 1.0f, high = 0.0f;
    const auto see = [&](const glm::vec3& place) {
        const float at = gradient.radial ? physics::radial_ramp(place, gradient.from, gradient.inner, gradient.outer)
                                         : physics::linear_ramp(place, gradient.from, gradient.to);
        low = std::min(low, at), high = std::max(high, at);
    };
    for (int corner = 0; corner < 8; ++corner)
        see(glm::mix(local.low, local.high, glm::vec3(corner & 1, (corner >> 1) & 1, corner >> 2)));
    if (gradient.radial) see(glm::clamp(gradient.from, local.low, local.high));
    const float spread = (kSlack - 1.0f) * (std::abs(gradient.start) + std::abs(gradient.end));
    return finite(std::max(glm::mix(gradient.start, gradient.end, low), glm::mix(gradient.start, gradient.end, high)) +
                  spread);
}

}  // namespace tyndall
