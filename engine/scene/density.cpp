#include "scene/density.h"

#include <algorithm>
#include <cmath>

#include "physics/physics.h"

namespace tyndall {
namespace {

// Alternatives of DensityField.
constexpr size_t kHeight = 1, kBlobs = 2, kNoise = 3, kGrid = 4;
static_assert(std::is_same_v<std::variant_alternative_t<kHeight, DensityField>, HeightDensity> &&
              std::is_same_v<std::variant_alternative_t<kBlobs, DensityField>, BlobDensity> &&
              std::is_same_v<std::variant_alternative_t<kNoise, DensityField>, NoiseDensity> &&
              std::is_same_v<std::variant_alternative_t<kGrid, DensityField>, GridDensity>);
// Evaluation rounds; a bound is this much above what exact arithmetic gives.
constexpr float kSlack = 1.0f + 1e-5f;
// Of physics::gradient_noise, over every choice of gradients: its greatest value, and its steepest slope per cell.
constexpr float kNoiseLimit = 1.04f;
constexpr float kNoiseSlope = 3.9f;
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

/// Greatest values of ever larger blocks of voxels, each level half the size of the one before: a large box looks at
/// few of them. Level 0 is the volume itself.
struct DensityEvaluator::MaximaOfBlocks {
    std::vector<Volume> levels;

    explicit MaximaOfBlocks(const Volume& volume) {
        const Volume* finer = &volume;
        levels.reserve(32);
        while (std::max({finer->size.x, finer->size.y, finer->size.z}) > 1) {
            levels.push_back(halved(*finer));
            finer = &levels.back();
        }
    }

    static Volume halved(const Volume& finer) {
        Volume coarser;
        coarser.size = (finer.size + 1) / 2;
        coarser.values.assign(size_t(coarser.size.x) * size_t(coarser.size.y) * size_t(coarser.size.z), 0.0f);
        size_t index = 0;
        for (int z = 0; z < finer.size.z; ++z)
            for (int y = 0; y < finer.size.y; ++y)
                for (int x = 0; x < finer.size.x; ++x, ++index) {
                    const size_t row = size_t(z / 2) * size_t(coarser.size.y) + size_t(y / 2);
                    float& block = coarser.values[row * size_t(coarser.size.x) + size_t(x / 2)];
                    block = std::max(block, finer.values[index]);
                }
        return coarser;
    }

    /// Greatest voxel between `low` and `high`, both inside the volume.
    [[nodiscard]] float greatest(const Volume& volume, glm::ivec3 low, glm::ivec3 high) const {
        constexpr int kMost = 6;  // blocks along an axis
        size_t level = 0;
        for (; level < levels.size(); ++level, low /= 2, high /= 2) {
            const glm::ivec3 count = high - low + 1;
            if (std::max({count.x, count.y, count.z}) <= kMost) break;
        }
        const Volume& blocks = level == 0 ? volume : levels[level - 1];
        float greatest = 0.0f;
        for (int z = low.z; z <= high.z; ++z)
            for (int y = low.y; y <= high.y; ++y)
                for (int x = low.x; x <= high.x; ++x) greatest = std::max(greatest, blocks.at(x, y, z));
        return greatest;
    }
};

DensityEvaluator::DensityEvaluator(DensityField field, const glm::mat4& local_to_world, double time_s)
    : field_(std::move(field)) {
    if (const auto* height = std::get_if<HeightDensity>(&field_)) prepare_height(*height, local_to_world);
    if (const auto* blobs = std::get_if<BlobDensity>(&field_)) prepare_blobs(*blobs);
    if (const auto* noise = std::get_if<NoiseDensity>(&field_)) prepare_noise(*noise, local_to_world, time_s);
    if (const auto* grid = std::get_if<GridDensity>(&field_)) prepare_grid(*grid);
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
}

void DensityEvaluator::prepare_grid(const GridDensity& grid) {
    if (!grid.volume || grid.volume->volume.values.empty()) return;
    const Volume& volume = grid.volume->volume;
    const glm::vec3 size(volume.size);
    for (int column = 0; column < 4; ++column)
        map_[column] = glm::vec4(glm::vec3(grid.to_volume[column]) * size, grid.to_volume[column].w);
    map_[3] -= glm::vec4(0.5f, 0.5f, 0.5f, 0.0f);
    for (int column = 0; column < 4; ++column)
        if (!(glm::dot(map_[column], map_[column]) < std::numeric_limits<float>::max())) return;
    maxima_ = std::make_shared<const MaximaOfBlocks>(volume);
}

float DensityEvaluator::at(const glm::vec3& local) const {
    switch (field_.index()) {
        case kHeight:
            return float(
                std::exp(std::min(exponent_ + glm::dot(exponent_slope_, glm::dvec3(local)), kLargestExponent)));
        case kBlobs:
            return blobs_at(local);
        case kNoise: {
            const auto& noise = *std::get_if<NoiseDensity>(&field_);
            return finite(
                physics::noise_density(glm::vec3(map_ * glm::vec4(local, 1.0f)), octaves_of(noise), noise.coverage));
        }
        case kGrid:
            return grid_at(local);
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

float DensityEvaluator::grid_at(const glm::vec3& local) const {
    if (!maxima_) return 0.0f;
    const auto& grid = *std::get_if<GridDensity>(&field_);
    const Volume& volume = grid.volume->volume;
    const glm::vec3 place = glm::vec3(map_ * glm::vec4(local, 1.0f));
    const glm::vec3 end = glm::vec3(volume.size) - 0.5f;
    // written so that what is not a number is outside
    if (!(place.x >= -0.5f && place.y >= -0.5f && place.z >= -0.5f && place.x <= end.x && place.y <= end.y &&
          place.z <= end.z))
        return 0.0f;
    const glm::vec3 whole = glm::floor(place);
    const glm::vec3 part = place - whole;
    const glm::ivec3 last = volume.size - 1;
    const glm::ivec3 low = glm::clamp(glm::ivec3(whole), glm::ivec3(0), last);
    const glm::ivec3 high = glm::clamp(glm::ivec3(whole) + 1, glm::ivec3(0), last);
    const auto row = [&](int y, int z) { return glm::mix(volume.at(low.x, y, z), volume.at(high.x, y, z), part.x); };
    const float value = glm::mix(glm::mix(row(low.y, low.z), row(high.y, low.z), part.y),
                                 glm::mix(row(low.y, high.z), row(high.y, high.z), part.y), part.z);
    return finite(value * grid.scale);
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
            return grid_bound(local);
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
    const int octaves = octaves_of(noise);
    const glm::vec3 centre = glm::vec3(map_ * glm::vec4(local.centre(), 1.0f));
    const float radius = glm::length(mapped_half(map_, local)) + 1e-6f * glm::length(centre);
    float sum = 0.0f, variance = 0.0f;
    for (int octave = 0; octave < octaves; ++octave) {
        const float size = std::ldexp(1.0f, -octave);
        const float rise = kNoiseSlope * radius / size;
        const glm::vec3 place = physics::fractal_noise_place(centre, octave);
        const float middle = rise < 2.0f * kNoiseLimit
                                 ? physics::gradient_noise(place, physics::hash_pcg(uint32_t(octave)))
                                 : kNoiseLimit;
        sum += size * std::min(middle + rise, kNoiseLimit);
        variance += size * size;
    }
    const float most = kSlack * sum / std::sqrt(variance * physics::kGradientNoiseVariance);
    return std::min(kSlack * physics::noise_to_density(most, noise.coverage) + 1e-6f, 1.0f);
}

float DensityEvaluator::grid_bound(const Bounds& local) const {
    if (!maxima_) return 0.0f;
    const auto& grid = *std::get_if<GridDensity>(&field_);
    const Volume& volume = grid.volume->volume;
    const glm::vec3 centre = glm::vec3(map_ * glm::vec4(local.centre(), 1.0f));
    const glm::vec3 reach = glm::max(glm::abs(local.low), glm::abs(local.high));
    const Bounds about{-reach, reach};
    const glm::vec3 half =
        mapped_half(map_, local) + 0.01f + 1e-6f * (mapped_half(map_, about) + glm::vec3(volume.size));
    const glm::vec3 last(volume.size - 1);
    const glm::vec3 low = centre - half, high = centre + half;
    if (glm::any(glm::lessThan(high, glm::vec3(-0.5f))) || glm::any(glm::greaterThan(low, last + 0.5f))) return 0.0f;
    const glm::ivec3 first(glm::clamp(glm::floor(low), glm::vec3(0.0f), last));
    const glm::ivec3 past(glm::clamp(glm::floor(high) + 1.0f, glm::vec3(0.0f), last));
    return finite(kSlack * maxima_->greatest(volume, first, past) * grid.scale);
}

}  // namespace tyndall
