#include <algorithm>
#include <cmath>

#include "image/image.h"
#include "physics/physics.h"
#include "reference/lights.h"
#include "reference/textures.h"

namespace tyndall::reference {
namespace {

using glm::vec2;
using glm::vec3;

constexpr int kMostColumns = 1024;
constexpr float kUniformShare = 0.05f;  ///< of the density: bilinear lookups glow a little beside bright texels

float luminance(const vec3& v) {
    return physics::luminance_rec709(v);
}

}  // namespace

Environment::Environment(std::shared_ptr<const TextureAsset> image, const vec3& radiance, const glm::mat3& rotation)
    : image_(std::move(image)), radiance_(radiance), rotation_(rotation), mean_(luminance(radiance)) {
    if (!image_ || mean_ <= 0.0f) return;
    Image small = with_channels(to_float(image_->image), 3);
    if (small.width > kMostColumns)
        small = resize(small, kMostColumns, std::max(1, small.height * kMostColumns / small.width));
    width_ = small.width, height_ = small.height;
    columns_.resize(static_cast<size_t>(width_) * static_cast<size_t>(height_));
    rows_.resize(static_cast<size_t>(height_));
    double total = 0.0, sines = 0.0;
    for (int y = 0; y < height_; ++y) {
        const double sine = std::sin((y + 0.5) * physics::kPi / height_);
        double row = 0.0;
        for (int x = 0; x < width_; ++x) {
            const vec3 value(small.at(x, y, 0), small.at(x, y, 1), small.at(x, y, 2));
            row += static_cast<double>(std::max(luminance(value * radiance_), 0.0f)) * sine;
            columns_[static_cast<size_t>(y) * static_cast<size_t>(width_) + static_cast<size_t>(x)] =
                static_cast<float>(row);
        }
        sines += sine * width_;
        total += row;
        rows_[static_cast<size_t>(y)] = static_cast<float>(total);
    }
    mean_ = static_cast<float>(total / sines);
}

vec3 Environment::radiance(const vec3& direction) const {
    if (!image_) return radiance_;
    return radiance_ * sample_equirect(*image_, glm::transpose(rotation_) * direction);
}

float Environment::texel_pdf(int x, int y) const {
    const size_t row = static_cast<size_t>(y) * static_cast<size_t>(width_), at = row + static_cast<size_t>(x);
    const float power = columns_[at] - (x > 0 ? columns_[at - 1] : 0.0f);
    const float sine = std::sin((static_cast<float>(y) + 0.5f) * physics::kPi / static_cast<float>(height_));
    const float solid_angle = 2.0f * physics::kPi * physics::kPi * sine / static_cast<float>(width_ * height_);
    return power / (rows_.back() * solid_angle);
}

float Environment::pdf(const vec3& direction) const {
    if (rows_.empty()) return physics::kInverseFourPi;
    const vec2 uv = physics::direction_to_equirect(glm::transpose(rotation_) * direction);
    const int x = std::clamp(static_cast<int>(uv.x * static_cast<float>(width_)), 0, width_ - 1);
    const int y = std::clamp(static_cast<int>(uv.y * static_cast<float>(height_)), 0, height_ - 1);
    // the sine over a texel is not even: the density within it follows the direction's own
    const float middle = std::sin((static_cast<float>(y) + 0.5f) * physics::kPi / static_cast<float>(height_));
    const float sine = std::sin(std::clamp(uv.y, 1e-6f, 1.0f - 1e-6f) * physics::kPi);
    return kUniformShare * physics::kInverseFourPi + (1.0f - kUniformShare) * texel_pdf(x, y) * middle / sine;
}

vec3 Environment::sample(vec2 xi, float& density) const {
    vec3 direction;
    if (rows_.empty()) {
        direction = physics::sample_uniform_sphere(xi);
    } else if (xi.x < kUniformShare) {
        direction = physics::sample_uniform_sphere(vec2(xi.x / kUniformShare, xi.y));
    } else {
        const float row_wanted = (xi.x - kUniformShare) / (1.0f - kUniformShare) * rows_.back();
        const auto row = std::min<size_t>(
            static_cast<size_t>(std::upper_bound(rows_.begin(), rows_.end(), row_wanted) - rows_.begin()),
            rows_.size() - 1);
        const float row_low = row > 0 ? rows_[row - 1] : 0.0f;
        const float* first = &columns_[row * static_cast<size_t>(width_)];
        const float* last = first + width_;
        const float wanted = xi.y * last[-1];
        const auto column = std::min<std::ptrdiff_t>(std::upper_bound(first, last, wanted) - first, width_ - 1);
        const float column_low = column > 0 ? first[column - 1] : 0.0f;
        const auto share = [](float value, float low, float high) {
            return high > low ? std::clamp((value - low) / (high - low), 0.0f, 1.0f) : 0.5f;
        };
        const vec2 uv(
            (static_cast<float>(column) + share(wanted, column_low, first[column])) / static_cast<float>(width_),
            (static_cast<float>(row) + share(row_wanted, row_low, rows_[row])) / static_cast<float>(height_));
        direction = rotation_ * physics::equirect_to_direction(uv);
    }
    density = pdf(direction);
    return direction;
}

}  // namespace tyndall::reference
