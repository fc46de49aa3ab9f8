#include "app/expectations.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "core/error.h"
#include "core/paths.h"
#include "image/compare.h"
#include "image/image_io.h"

namespace tyndall {
namespace fs = std::filesystem;
namespace {

/// The file of a reference name, or nothing when the folder of references is not there.
std::optional<fs::path> reference_file(const CaptureFile& capture, const std::string& name) {
    constexpr std::string_view kPrefix = "references:";
    if (!name.starts_with(kPrefix)) return capture.file.parent_path() / name;
    const char* wanted = std::getenv("TYNDALL_REFERENCES");
    const fs::path folder = wanted ? fs::path(wanted) : paths::root().parent_path() / "shared" / "references";
    if (!fs::is_directory(folder)) return std::nullopt;
    return paths::resolve_asset(folder, name.substr(kPrefix.size()));
}

Image crop(const Image& image, const glm::vec4& region) {
    const auto pixel = [](float fraction, int size) {
        return std::clamp(static_cast<int>(std::lround(fraction * static_cast<float>(size))), 0, size);
    };
    const int x0 = pixel(region.x, image.width), y0 = pixel(region.y, image.height);
    const int x1 = std::max(x0 + 1, pixel(region.x + region.z, image.width)),
              y1 = std::max(y0 + 1, pixel(region.y + region.w, image.height));
    Image out(std::min(x1, image.width) - x0, std::min(y1, image.height) - y0, image.channels, image.type);
    const size_t texel = static_cast<size_t>(image.channels) * bytes_per_value(image.type);
    const size_t row = static_cast<size_t>(out.width) * texel;
    for (int y = 0; y < out.height; ++y) {
        const auto from =
            image.pixels.begin() +
            static_cast<std::ptrdiff_t>(
                (static_cast<size_t>(y + y0) * static_cast<size_t>(image.width) + static_cast<size_t>(x0)) * texel);
        std::copy_n(from, row, out.pixels.begin() + static_cast<std::ptrdiff_t>(static_cast<size_t>(y) * row));
    }
    return out;
}

void multiply(Image& image, float factor) {
    for (float& value : image.floats()) value *= factor;
}

bool finite(const Image& image) {
    const auto values = image.floats();
    return std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); });
}

double mean_luminance(const Image& image) {
    double sum = 0.0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            sum += 0.2126 * image.at(x, y, 0) + 0.7152 * image.at(x, y, 1) + 0.0722 * image.at(x, y, 2);
    return sum / (static_cast<double>(image.width) * image.height);
}

/// Collects measured values against limits into one line.
class Judgement {
 public:
    void limit(const char* what, double value, double limit) {
        if (limit < 0.0) return;
        const bool holds = value <= limit;
        add(fmt::format("{} {:.6g} (limit {:.6g})", what, value, limit), holds);
    }
    void note(const std::string& text) { add(text, true); }
    void add(const std::string& text, bool holds) {
        text_ += (text_.empty() ? "" : ", ") + text + (holds ? "" : " FAILED");
        held_ = held_ && holds;
    }
    [[nodiscard]] bool held() const { return held_; }
    [[nodiscard]] const std::string& text() const { return text_; }

 private:
    std::string text_;
    bool held_ = true;
};

void compare_with(Judgement& judgement, const Expectation& wanted, const Image& other, const Image& test) {
    const LinearDifference d = compare_linear(other, test);
    judgement.limit("relMSE", d.relative_mse, wanted.max_relmse);
    judgement.limit("mean error", std::abs(d.mean_ratio - 1.0), wanted.max_mean_error);
    judgement.limit("largest difference", d.max_difference, wanted.max_difference);
    judgement.note(fmt::format("mean ratio {:.4f}, PSNR {:.1f} dB, worst 8x8 block {:.4g} at {},{}", d.mean_ratio,
                               d.psnr_db, d.worst_block, d.worst_block_x, d.worst_block_y));
}

/// What of a picture the numbers are taken from.
Image judged_values(const CapturedPicture& picture, const Expectation& wanted) {
    return wanted.display ? to_float(picture.display) : picture.radiance;
}

Verdict judge_one(const CaptureFile& capture, const Expectation& wanted,
                  const std::map<std::string, CapturedPicture>& pictures) {
    const CapturedPicture& picture = pictures.at(wanted.of);
    Verdict verdict;
    Judgement judgement;
    judgement.add("no NaN or Inf", finite(picture.radiance));
    Image test = crop(judged_values(picture, wanted), wanted.region);
    if (wanted.box_filter > 1) test = box_downsample(test, wanted.box_filter);
    if (wanted.mean_between.y >= 0.0f) {
        const double mean = mean_luminance(test);
        judgement.add(
            fmt::format("mean luminance {:.6g} in [{:g}, {:g}]", mean, wanted.mean_between.x, wanted.mean_between.y),
            mean >= static_cast<double>(wanted.mean_between.x) && mean <= static_cast<double>(wanted.mean_between.y));
    }
    if (judgement.held() && !wanted.equals.empty()) {
        const CapturedPicture& other = pictures.at(wanted.equals);
        Image expected = crop(judged_values(other, wanted), wanted.region);
        if (wanted.box_filter > 1) expected = box_downsample(expected, wanted.box_filter);
        multiply(expected, wanted.scale);
        compare_with(judgement, wanted, expected, test);
        if (wanted.max_flip >= 0.0f) {
            const FlipDifference flip =
                compare_flip(crop(other.display, wanted.region), crop(picture.display, wanted.region));
            judgement.limit("FLIP", flip.mean, wanted.max_flip);
            judgement.note(fmt::format("worst FLIP block {:.4g} at {},{}", flip.worst_block, flip.worst_block_x,
                                       flip.worst_block_y));
            verdict.heat_map = heat_map(flip.map);
        }
    }
    if (judgement.held() && !wanted.reference.empty()) {
        const auto file = reference_file(capture, wanted.reference);
        if (!file) {
            verdict.outcome = Verdict::Outcome::skipped;
            verdict.text = wanted.of + ": skipped, the folder of references is not there (set TYNDALL_REFERENCES)";
            return verdict;
        }
        Image expected = with_channels(to_float(load_image(*file)), 3);
        multiply(expected, wanted.scale);
        compare_with(judgement, wanted, expected, test);
    }
    verdict.outcome = judgement.held() ? Verdict::Outcome::held : Verdict::Outcome::failed;
    verdict.text = wanted.of + (wanted.equals.empty() ? "" : " = " + wanted.equals) + ": " + judgement.text() +
                   (wanted.reason.empty() ? "" : " [" + wanted.reason + "]");
    return verdict;
}

}  // namespace

std::vector<Verdict> judge(const CaptureFile& capture, const std::map<std::string, CapturedPicture>& pictures) {
    std::vector<Verdict> verdicts;
    for (const Expectation& wanted : capture.expect) {
        try {
            verdicts.push_back(judge_one(capture, wanted, pictures));
        } catch (const Error& error) {
            verdicts.push_back({Verdict::Outcome::failed, wanted.of + ": " + error.what(), {}});
        }
    }
    return verdicts;
}

}  // namespace tyndall
