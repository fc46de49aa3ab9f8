#include "app/stored_reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/reference_recipe.h"
#include "core/error.h"
#include "image/image_io.h"
#include "physics/physics.h"

namespace tyndall {
namespace fs = std::filesystem;
namespace {

constexpr float kLargestHalf = 65504.0f;
/// Below this mean a half float's smallest step, 2^-24, would show.
constexpr double kDarkestMean = 1e-3;
constexpr int kRadianceBits = 11;  ///< significant bits of a half float
constexpr int kVarianceBits = 5;

/// The largest power of two that is not above `value`, which is positive.
double power_of_two_below(double value) {
    int exponent = 0;
    (void)std::frexp(value, &exponent);
    return std::ldexp(1.0, exponent - 1);
}

/// A value between two steps becomes one of them at random, so that it keeps its mean; the variance grows by what that
/// adds.
void round_to_noise(float& value, float& variance, float random) {
    if (value == 0.0f) return;
    double step = power_of_two_below(std::abs(static_cast<double>(value))) * std::ldexp(1.0, 1 - kRadianceBits);
    if (variance > 0.0f) step = std::max(step, power_of_two_below(0.5 * std::sqrt(static_cast<double>(variance))));
    const double steps = static_cast<double>(value) / step;
    const double low = std::floor(steps), share = steps - low;
    value = static_cast<float>((share > static_cast<double>(random) ? low + 1.0 : low) * step);
    variance += static_cast<float>(step * step * share * (1.0 - share));
}

float with_few_bits(float value) {
    if (value == 0.0f) return value;
    const double step = power_of_two_below(static_cast<double>(value)) * std::ldexp(1.0, 1 - kVarianceBits);
    return static_cast<float>(std::round(static_cast<double>(value) / step) * step);
}

/// Whether half floats hold the picture as well as its noise asks.
bool fits_half(const Image& radiance) {
    double sum = 0.0;
    float largest = 0.0f;
    for (const float value : radiance.floats()) {
        sum += static_cast<double>(std::abs(value));
        largest = std::max(largest, std::abs(value));
    }
    return largest <= 0.5f * kLargestHalf && sum / static_cast<double>(radiance.value_count()) >= kDarkestMean;
}

/// Where a picture is not a reference's, and why. Empty: it is.
std::string broken_at(const NoisyPicture& picture) {
    const auto look = [&](const Image& image, const char* what, bool positive) -> std::string {
        const auto values = image.floats();
        for (size_t i = 0; i < values.size(); ++i)
            if (!std::isfinite(values[i]) || (positive && values[i] < 0.0f))
                return fmt::format("the {} is {} at x {}, y {}", what, values[i],
                                   i / 3 % static_cast<size_t>(image.width), i / 3 / static_cast<size_t>(image.width));
        return {};
    };
    const std::string radiance = look(picture.radiance, "radiance", false);
    return radiance.empty() ? look(picture.variance, "variance", true) : radiance;
}

std::string advice(const CaptureFile& capture) {
    return "run tyndall capture --retrace " + capture.file.string();
}

}  // namespace

fs::path file_of(const CaptureFile& capture, const TracedReference& reference) {
    return capture.file.parent_path() / (reference.name + ".exr");
}

void save_reference(const fs::path& file, const NoisyPicture& picture, const std::string& recipe, int64_t samples,
                    int32_t seed) {
    if (picture.variance.value_count() != picture.radiance.value_count())
        throw Error(Diagnostic{{file.string()}, "a reference without a variance: nothing was written"});
    if (const std::string broken = broken_at(picture); !broken.empty())
        throw Error(Diagnostic{{file.string()}, broken + ": nothing was written"});
    NoisyPicture rounded = picture;
    const auto radiance = rounded.radiance.floats(), variance = rounded.variance.floats();
    for (size_t i = 0; i < radiance.size(); ++i) {
        const float random = static_cast<float>(physics::hash_pcg(static_cast<uint32_t>(i)) >> 8u) * 0x1p-24f;
        round_to_noise(radiance[i], variance[i], random);
        variance[i] = with_few_bits(variance[i]);
    }
    Image all(picture.radiance.width, picture.radiance.height, 6, Image::Type::f32);
    for (size_t i = 0; i < radiance.size(); ++i) {
        all.floats()[i / 3 * 6 + i % 3] = radiance[i];
        all.floats()[i / 3 * 6 + 3 + i % 3] = variance[i];
    }
    const std::vector<std::string> variances{"variance.R", "variance.G", "variance.B"};
    save_exr(file, all,
             {.half = fits_half(rounded.radiance),
              .channel_names = {"R", "G", "B", "variance.R", "variance.G", "variance.B"},
              .metadata = {{"tyndall.recipe", recipe},
                           {"tyndall.samples", std::to_string(samples)},
                           {"tyndall.seed", std::to_string(seed)}},
              .full_channels = variances});
}

NoisyPicture load_reference(const CaptureFile& capture, const TracedReference& reference) {
    const fs::path file = file_of(capture, reference);
    if (!fs::exists(file))
        throw Error(
            Diagnostic{{file.string()}, "the reference '" + reference.name + "' is not there", advice(capture)});
    const std::string recipe = load_text_attribute(file, "tyndall.recipe");
    if (const std::string other = difference_of_recipes(recipe, recipe_of(capture, reference)); !other.empty())
        throw Error(Diagnostic{{file.string()}, other, advice(capture)});
    NoisyPicture picture{load_layer(file, ""), load_layer(file, "variance")};
    const glm::ivec2 size = size_of(capture, reference);
    for (const Image* image : {&picture.radiance, &picture.variance})
        if (image->width != size.x || image->height != size.y || image->channels != 3)
            throw Error(Diagnostic{
                {file.string()},
                fmt::format("a picture of {}x{} pixels and {} channels", image->width, image->height, image->channels),
                fmt::format("{}x{} pixels and 3 channels: {}", size.x, size.y, advice(capture))});
    if (const std::string broken = broken_at(picture); !broken.empty())
        throw Error(Diagnostic{{file.string()}, broken, "finite numbers: " + advice(capture)});
    return picture;
}

}  // namespace tyndall
