#include "reference/film.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"

namespace tyndall::reference {
namespace {

const double kRadianceQuantum = std::ldexp(1.0, -40);
const double kSquareQuantum = std::ldexp(1.0, -60);
const double kUnitQuantum = std::ldexp(1.0, -32);  ///< of albedo and normal
constexpr double kLargestSum = 1e37;               ///< of one addend; the sum has 127 bits, 1.7e38

WideSum wide(double value, double quantum) {
    const double scaled = value / quantum;
    // What is not finite is a defect of the tracer: it shows as black, never as a sum that is destroyed.
    if (!std::isfinite(scaled)) return 0;
    return static_cast<WideSum>(std::nearbyint(std::clamp(scaled, -kLargestSum, kLargestSum)));
}

int64_t narrow(float value) {
    return static_cast<int64_t>(std::nearbyint(static_cast<double>(value) / kUnitQuantum));
}

}  // namespace

Film::Film(glm::ivec2 size, int batch, float unit, std::string recipe, bool components)
    : size_(size), batch_(batch), unit_(unit), recipe_(std::move(recipe)) {
    check_image_size(size.x, size.y, 3, Image::Type::f32);
    const size_t count = static_cast<size_t>(size.x) * static_cast<size_t>(size.y);
    pixels_.resize(count);
    if (components) components_.resize(count);
}

void Film::add(glm::ivec2 at, const PixelBatch& means) {
    const size_t index = static_cast<size_t>(at.y) * static_cast<size_t>(size_.x) + static_cast<size_t>(at.x);
    Pixel& pixel = pixels_[index];
    const double scale = 1.0 / static_cast<double>(unit_);
    for (int c = 0; c < 3; ++c) {
        const double value = static_cast<double>(means.radiance[c]) * scale;
        pixel.radiance[c] += wide(value, kRadianceQuantum);
        pixel.squares[c] += wide(value * value, kSquareQuantum);
        pixel.albedo[c] += narrow(means.albedo[c]);
        pixel.normal[c] += narrow(means.normal[c]);
    }
    if (components_.empty()) return;
    Components& parts = components_[index];
    for (int c = 0; c < 3; ++c) {
        parts.emission[c] += wide(static_cast<double>(means.emission[c]) * scale, kRadianceQuantum);
        parts.surface[c] += wide(static_cast<double>(means.surface[c]) * scale, kRadianceQuantum);
        parts.medium[c] += wide(static_cast<double>(means.medium[c]) * scale, kRadianceQuantum);
    }
}

void Film::finish_batch(int64_t batch) {
    done_.insert(batch);
}

void Film::merge(const Film& other) {
    if (other.size_ != size_)
        throw Error(fmt::format("the films are {}x{} and {}x{}: only films of one size can be merged", size_.x, size_.y,
                                other.size_.x, other.size_.y));
    if (other.recipe_ != recipe_)
        throw Error("the films are of different scenes or settings:\n  " + recipe_ + "\n  " + other.recipe_);
    for (const int64_t batch : other.done_)
        if (done_.contains(batch)) throw Error(fmt::format("batch {} of samples is in both films", batch));
    for (size_t i = 0; i < pixels_.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            pixels_[i].radiance[c] += other.pixels_[i].radiance[c];
            pixels_[i].squares[c] += other.pixels_[i].squares[c];
            pixels_[i].albedo[c] += other.pixels_[i].albedo[c];
            pixels_[i].normal[c] += other.pixels_[i].normal[c];
        }
    for (size_t i = 0; i < components_.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            components_[i].emission[c] += other.components_[i].emission[c];
            components_[i].surface[c] += other.components_[i].surface[c];
            components_[i].medium[c] += other.components_[i].medium[c];
        }
    done_.insert(other.done_.begin(), other.done_.end());
}

Image Film::mean_of(FunctionRef<double(size_t pixel, int channel)> sum) const {
    Image image(size_.x, size_.y, 3, Image::Type::f32);
    if (done_.empty()) return image;
    const double share = 1.0 / static_cast<double>(batches());
    const auto values = image.floats();
    for (size_t i = 0; i < pixels_.size(); ++i)
        for (int c = 0; c < 3; ++c) values[3 * i + static_cast<size_t>(c)] = static_cast<float>(sum(i, c) * share);
    return image;
}

Image Film::radiance() const {
    const double scale = kRadianceQuantum * static_cast<double>(unit_);
    return mean_of([&](size_t i, int c) { return static_cast<double>(pixels_[i].radiance[c]) * scale; });
}

double Film::variance_at(size_t pixel, int channel) const {
    const auto n = static_cast<double>(batches());
    if (n < 2) return std::numeric_limits<double>::infinity();
    const double mean = static_cast<double>(pixels_[pixel].radiance[channel]) * kRadianceQuantum / n;
    const double square = static_cast<double>(pixels_[pixel].squares[channel]) * kSquareQuantum / n;
    const double unit = static_cast<double>(unit_);
    return std::max(0.0, square - mean * mean) / (n - 1.0) * unit * unit;
}

Image Film::variance() const {
    const auto n = static_cast<double>(batches());
    return mean_of([&](size_t i, int c) { return variance_at(i, c) * n; });
}

Image Film::albedo() const {
    return mean_of([&](size_t i, int c) { return static_cast<double>(pixels_[i].albedo[c]) * kUnitQuantum; });
}

Image Film::normal() const {
    return mean_of([&](size_t i, int c) { return static_cast<double>(pixels_[i].normal[c]) * kUnitQuantum; });
}

Image Film::component(Component which) const {
    const double scale = kRadianceQuantum * static_cast<double>(unit_);
    return mean_of([&](size_t i, int c) {
        const Components& parts = components_[i];
        const WideSum scattered_more = pixels_[i].radiance[c] - parts.emission[c] - parts.surface[c] - parts.medium[c];
        switch (which) {
            case Component::emission:
                return static_cast<double>(parts.emission[c]) * scale;
            case Component::surface:
                return static_cast<double>(parts.surface[c]) * scale;
            case Component::medium:
                return static_cast<double>(parts.medium[c]) * scale;
            default:
                return static_cast<double>(scattered_more) * scale;
        }
    });
}

double Film::noise() const {
    if (batches() < 2) return std::numeric_limits<double>::infinity();
    constexpr double kLuminance[3] = {0.2126, 0.7152, 0.0722};
    const double scale = kRadianceQuantum * static_cast<double>(unit_) / static_cast<double>(batches());
    double mean = 0, variance = 0;
    for (size_t i = 0; i < pixels_.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            mean += kLuminance[c] * static_cast<double>(pixels_[i].radiance[c]) * scale;
            variance += kLuminance[c] * variance_at(i, c);
        }
    const auto count = static_cast<double>(pixels_.size());
    return mean > 0 ? std::sqrt(variance / count) / (mean / count) : 0.0;
}

}  // namespace tyndall::reference
