#include "app/expectations.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "app/stored_reference.h"
#include "core/error.h"
#include "core/paths.h"
#include "image/compare.h"
#include "image/image_io.h"

namespace tyndall {
namespace fs = std::filesystem;

std::optional<fs::path> reference_picture(const fs::path& folder, const std::string& name) {
    if (!name.starts_with(kReferencesPrefix)) return paths::resolve_asset(fs::absolute(folder), name);
    const char* wanted = std::getenv("TYNDALL_REFERENCES");
    const fs::path references = wanted ? fs::path(wanted) : paths::root().parent_path() / "shared" / "references";
    if (!fs::is_directory(references)) return std::nullopt;
    return paths::resolve_asset(references, name.substr(kReferencesPrefix.size()));
}

namespace {

/// A scene-linear picture and, where its file has one, its variance.
NoisyPicture load_picture(const fs::path& file) {
    NoisyPicture picture{with_channels(to_float(load_image(file)), 3), {}};
    const std::vector<std::string> layers = load_layer_names(file);
    if (std::ranges::find(layers, "variance") != layers.end()) picture.variance = load_layer(file, "variance");
    return picture;
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

void multiply(NoisyPicture& picture, float factor) {
    for (float& value : picture.radiance.floats()) value *= factor;
    if (picture.variance.empty()) return;
    for (float& value : picture.variance.floats()) value *= factor * factor;
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

/// Collects what was found into one line.
class Judgement {
 public:
    void add(const std::string& text, bool holds = true) {
        text_ += (text_.empty() ? "" : ", ") + text + (holds ? "" : " FAILED");
        held_ = held_ && holds;
    }
    void add(const char* what, const MeasuredLimit& found) {
        add(fmt::format("{} {:.6g} (limit{} {:.6g})", what, found.value, found.at_least ? " at least" : "",
                        found.limit),
            found.held);
    }
    [[nodiscard]] bool held() const { return held_; }
    [[nodiscard]] const std::string& text() const { return text_; }

 private:
    std::string text_;
    bool held_ = true;
};

/// Judges one expectation.
class Judge {
 public:
    Judge(const CaptureFile& capture, const Expectation& wanted, const std::map<std::string, CapturedPicture>& pictures,
          const std::string& camera)
        : capture_(capture), wanted_(wanted), pictures_(pictures), camera_(camera), picture_(pictures.at(wanted.of)) {}

    Verdict verdict() {
        test_ = values(picture_);
        judgement_.add("no NaN or Inf", finite(picture_.radiance));
        judge_mean();
        if (!wanted_.equals.empty()) compare_with_variant();
        if (!wanted_.reference.empty()) compare_with_file();
        if (!wanted_.traced.empty()) compare_with_traced();
        if (verdict_.outcome == Verdict::Outcome::skipped) return std::move(verdict_);
        verdict_.outcome = judgement_.held() ? Verdict::Outcome::held : Verdict::Outcome::failed;
        verdict_.text = wanted_.of + (wanted_.equals.empty() ? "" : " = " + wanted_.equals) + ": " + judgement_.text() +
                        (wanted_.reason.empty() ? "" : " [" + wanted_.reason + "]");
        return std::move(verdict_);
    }

 private:
    /// What of a picture the numbers are taken from.
    [[nodiscard]] Image values(const CapturedPicture& picture) const {
        const Image all = wanted_.display ? to_float(picture.display) : picture.radiance;
        return wanted_.box_filter > 1 ? box_downsample(all, wanted_.box_filter) : all;
    }

    void judge_mean() {
        if (wanted_.mean_between.y < 0.0f) return;
        const double mean = mean_luminance(crop(test_, wanted_.region));
        judgement_.add(
            fmt::format("mean luminance {:.6g} in [{:g}, {:g}]", mean, wanted_.mean_between.x, wanted_.mean_between.y),
            mean >= static_cast<double>(wanted_.mean_between.x) && mean <= static_cast<double>(wanted_.mean_between.y));
    }

    void compare_with_variant() {
        const CapturedPicture& other = pictures_.at(wanted_.equals);
        compare(Backing::variant, wanted_.equals, {values(other), {}}, &other);
    }

    void compare_with_file() {
        const auto file = reference_picture(capture_.file.parent_path(), wanted_.reference);
        if (!file) return skip("the folder of references is not there (set TYNDALL_REFERENCES)");
        if (wanted_.baseline) judgement_.add("a baseline, no truth backs it");
        compare(wanted_.baseline ? Backing::baseline : Backing::truth, wanted_.reference, load_picture(*file));
    }

    void compare_with_traced() {
        const TracedReference& reference = capture_.reference(wanted_.traced);
        const std::string traced = capture_.camera_of(reference), own = capture_.variant(wanted_.of).camera;
        if (traced != (own.empty() ? camera_ : own))
            return skip(fmt::format("'{}' was traced through {}", wanted_.traced,
                                    traced.empty() ? "the scene's own camera" : "camera '" + traced + "'"));
        compare(Backing::truth, wanted_.traced, load_reference(capture_, reference));
    }

    void skip(const std::string& why) {
        verdict_.outcome = Verdict::Outcome::skipped;
        verdict_.text = wanted_.of + ": skipped, " + why;
    }

    /// `shown`: the other variant's pictures, whose display pictures FLIP compares.
    void compare(Backing backing, const std::string& with, NoisyPicture other, const CapturedPicture* shown = nullptr) {
        multiply(other, wanted_.scale);
        Compared found{backing, with, {crop(other.radiance, wanted_.region), {}}, {}, {}};
        found.test = crop(fitted_to(test_, other.radiance), wanted_.region);
        if (!other.variance.empty()) found.reference.variance = crop(other.variance, wanted_.region);
        measure_linear(found);
        if (wanted_.max_flip >= 0.0f && finite(found.test)) measure_flip(found, shown);
        if (wanted_.min_z_p >= 0.0f && backing != Backing::variant && finite(found.test)) measure_noise(found);
        verdict_.compared.push_back(std::move(found));
    }

    void limit(Compared& found, const char* what, const char* metric, double value, float limit,
               bool at_least = false) {
        if (limit < 0.0f) return;
        const auto bound = static_cast<double>(limit);
        found.limits.push_back({metric, value, bound, at_least, at_least ? value >= bound : value <= bound});
        judgement_.add(what, found.limits.back());
    }

    void measure_linear(Compared& found) {
        const LinearDifference d = compare_linear(found.reference.radiance, found.test);
        limit(found, "relMSE", "relmse", d.relative_mse, wanted_.max_relmse);
        limit(found, "mean error", "mean_error", std::abs(d.mean_ratio - 1.0), wanted_.max_mean_error);
        limit(found, "largest difference", "max_difference", d.max_difference, wanted_.max_difference);
        if (d.not_finite > 0) return;
        judgement_.add(fmt::format("mean ratio {:.4f}, PSNR {:.1f} dB, worst 8x8 block {:.4g} at {},{}", d.mean_ratio,
                                   d.psnr_db, d.worst_block, d.worst_block_x, d.worst_block_y));
        Image relative = d.map;
        for (float& value : relative.floats()) value = std::sqrt(value);
        verdict_.heat_map = heat_map(relative);
    }

    void measure_flip(Compared& found, const CapturedPicture* shown) {
        const Image& reference = found.reference.radiance;
        const double exposure = display_exposure(reference);
        const FlipDifference flip =
            shown ? compare_flip(crop(shown->display, wanted_.region), crop(picture_.display, wanted_.region))
                  : compare_flip(encoded_for_display(reference, exposure), encoded_for_display(found.test, exposure));
        limit(found, "FLIP", "flip", flip.mean, wanted_.max_flip);
        judgement_.add(
            fmt::format("worst FLIP block {:.4g} at {},{}", flip.worst_block, flip.worst_block_x, flip.worst_block_y));
        verdict_.heat_map = heat_map(flip.map);
    }

    void measure_noise(Compared& found) {
        if (found.reference.variance.empty())
            throw Error("'" + found.with + "' has no variance, which min_z_p needs (expected a traced reference)");
        const Image exact(found.test.width, found.test.height, 3, Image::Type::f32);
        const ZTest z = z_test(found.reference, {found.test, exact});
        limit(found, "Z-test p", "z_p", z.p, wanted_.min_z_p, true);
        judgement_.add(
            fmt::format("worst z {:.1f} at {},{}, mean z^2 {:.2f}", z.worst, z.worst_x, z.worst_y, z.mean_square));
    }

    const CaptureFile& capture_;
    const Expectation& wanted_;
    const std::map<std::string, CapturedPicture>& pictures_;
    const std::string& camera_;
    const CapturedPicture& picture_;
    Image test_;
    Judgement judgement_;
    Verdict verdict_;
};

}  // namespace

std::vector<Verdict> judge(const CaptureFile& capture, const std::map<std::string, CapturedPicture>& pictures,
                           const std::string& camera) {
    std::vector<Verdict> verdicts;
    for (const Expectation& wanted : capture.expect) {
        try {
            verdicts.push_back(Judge(capture, wanted, pictures, camera).verdict());
        } catch (const Error& error) {
            verdicts.push_back({Verdict::Outcome::failed, wanted.of + ": " + error.what(), {}, {}});
        }
    }
    return verdicts;
}

}  // namespace tyndall
