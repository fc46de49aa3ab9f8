// compare: how far pictures are from a reference.

#include "image/comparison.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "core/error.h"
#include "core/paths.h"
#include "image/image_io.h"
#include "report/entry.h"

namespace tyndall {
namespace fs = std::filesystem;
namespace {

using nlohmann::json;

struct Options {
    std::string reference;
    std::vector<std::string> tests, limits;
    std::string layer, mask, crop, json, report, history, kind = "reference", heat;
    double significance = 0, noise = 0;
    ComparisonOptions comparison;
    bool fast = false;
};

/// A picture and, where its file has one, the variance of its values.
NoisyPicture load(const std::string& file, const std::string& layer) {
    NoisyPicture picture{to_float(load_layer(file, layer)), {}};
    if (picture.radiance.channels < 3) picture.radiance = with_channels(picture.radiance, 3);
    const std::vector<std::string> layers = load_layer_names(file);
    if (layer.empty() && std::ranges::find(layers, "variance") != layers.end())
        picture.variance = load_layer(file, "variance");
    return picture;
}

double number(const std::string& text, const std::string& of) {
    double value = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    if (read.ec != std::errc() || read.ptr != text.data() + text.size())
        throw Error("'" + text + "' is no number (" + of + ")");
    return value;
}

struct Rectangle {
    int x = 0, y = 0, width = 0, height = 0;

    [[nodiscard]] Image of(const Image& image, int scale = 1) const {
        return width == 0 || image.empty() ? image
                                           : cropped(image, x * scale, y * scale, width * scale, height * scale);
    }
};

Rectangle parse_crop(const std::string& text) {
    if (text.empty()) return {};
    Rectangle r;
    if (char rest = 0; std::sscanf(text.c_str(), "%d,%d,%d,%d%c", &r.x, &r.y, &r.width, &r.height, &rest) == 4 &&
                       r.width > 0 && r.height > 0)
        return r;
    throw Error("--crop '" + text + "' is no rectangle (expected X,Y,WIDTH,HEIGHT in the reference's pixels)");
}

/// Compares every test with the reference, prints, and writes what was asked for.
class Run {
 public:
    explicit Run(const Options& options) : options_(options), crop_(parse_crop(options.crop)) {
        for (const std::string& limit : options.limits) {
            const size_t equals = limit.find('=');
            if (equals == std::string::npos)
                throw Error("--metric '" + limit + "' has no limit (expected NAME=LIMIT, such as relmse=0.01)");
            limits_.emplace_back(metric_called(limit.substr(0, equals)).name,
                                 number(limit.substr(equals + 1), "the limit of " + limit.substr(0, equals)));
        }
        if (options.significance > 0) limits_.emplace_back("z_p", options.significance);
        reference_ = load(options.reference, options.layer);
        whole_ = reference_.radiance;
        whole_.pixels.clear();
        load_mask();
        if (reference_.variance.empty() && options.noise > 0)
            reference_.variance = variance_of_relative_noise(with_channels(reference_.radiance, 3), options.noise);
        if (options.significance > 0 && reference_.variance.empty())
            throw Error(Diagnostic{{options.reference},
                                   "has no layer 'variance', which a Z-test needs",
                                   "a picture that was traced here, or --reference-noise"});
        reference_ = {crop_.of(reference_.radiance), crop_.of(reference_.variance)};
    }

    int all() {
        report_.title = "Comparison with " + fs::path(options_.reference).filename().string();
        for (const std::string& test : options_.tests) compare(test);
        print_summary();
        write_json();
        if (!options_.report.empty()) {
            report_.history = options_.history;
            report::write_report(options_.report, report_);
            fmt::print("report: {}\n", (fs::path(options_.report) / "index.html").string());
        }
        return std::ranges::all_of(report_.entries, [](const auto& entry) { return entry.held; }) ? 0 : 1;
    }

 private:
    void load_mask() {
        if (options_.mask.empty()) return;
        const Image mask = load_image(options_.mask);
        if (mask.width != whole_.width || mask.height != whole_.height)
            throw Error(Diagnostic{{options_.mask},
                                   fmt::format("a mask of {}x{} pixels", mask.width, mask.height),
                                   fmt::format("the reference's {}x{}", whole_.width, whole_.height)});
        mask_ = mask_of(crop_.of(mask));
    }

    void compare(const std::string& file) {
        report::Entry entry;
        entry.name = name_of_entry(file);
        entry.kind = options_.kind == "baseline"  ? report::Kind::baseline
                     : options_.kind == "variant" ? report::Kind::variant
                                                  : report::Kind::reference;
        entry.reference_name = fs::path(options_.reference).filename().string();
        entry.test_name = fs::path(file).filename().string();
        const NoisyPicture test = load(file, options_.layer);
        ComparisonOptions how = options_.comparison;
        how.mask = mask_;
        how.hdr_flip = !options_.fast;
        if (options_.significance > 0) how.significance = options_.significance;
        try {
            // Checked before cropping, so that the message tells the pictures' own sizes.
            (void)fitted_to(test.radiance, Image(whole_.width, whole_.height, 3, Image::Type::u8));
            const int scale = test.radiance.width / whole_.width;
            entry.reference = reference_.radiance;
            entry.test = crop_.of(test.radiance, scale);
            const Comparison found = report::compare(entry, how, reference_.variance, crop_.of(test.variance, scale));
            worst_.push_back(found.worst);
        } catch (Error& error) {
            throw error.within("comparing " + file + " with " + options_.reference);
        }
        for (const auto& [metric, limit] : limits_) report::hold(entry, metric, limit);
        report_.entries.push_back(std::move(entry));
        print(file, report_.entries.back());
    }

    /// The file's name, with its folder where another test has the same.
    std::string name_of_entry(const std::string& file) const {
        const std::string name = fs::path(file).filename().string();
        const auto same = std::ranges::count_if(
            options_.tests, [&](const std::string& other) { return fs::path(other).filename() == name; });
        return same > 1 ? file : name;
    }

    void print(const std::string& file, const report::Entry& entry) const {
        fmt::print("{}\n", file);
        for (const Metric& metric : metrics_with_limits())
            if (const auto found = entry.metrics.find(metric.name); found != entry.metrics.end())
                fmt::print("  {:22} {:<12.6g}{}\n", metric.name, found->second, metric.about);
        const auto& worst = worst_.back();
        if (!worst.empty()) fmt::print("  worst 8x8 blocks (relative squared error):");
        for (size_t i = 0; i < std::min<size_t>(worst.size(), 4); ++i)
            fmt::print("  x {} y {} ({:.4g})", worst[i].x + crop_.x, worst[i].y + crop_.y, worst[i].mean);
        fmt::print("{}", worst.empty() ? "" : "\n");
        for (const std::string& note : entry.notes) fmt::print("  note: {}\n", note);
        for (const report::Limit& limit : entry.limits) {
            const auto found = entry.metrics.find(limit.metric);
            fmt::print("  {} {} {} (limit: at {} {:g})\n", limit.held ? "ok     " : "FAILED ", limit.metric,
                       found == entry.metrics.end() ? "not measured" : fmt::format("{:.6g}", found->second),
                       limit.at_least ? "least" : "most", limit.limit);
        }
    }

    /// One line a test, of the numbers that people compare first.
    void print_summary() const {
        if (report_.entries.size() < 2) return;
        constexpr const char* kColumns[] = {"relmse",  "hdr_flip",       "flip",      "ssim",
                                            "psnr_db", "max_difference", "mean_ratio"};
        fmt::print("\n{:32}", "test");
        for (const char* name : kColumns) fmt::print(" {:>14}", name);
        fmt::print("\n");
        for (const report::Entry& entry : report_.entries) {
            fmt::print("{:32}", entry.name);
            for (const char* name : kColumns) {
                const auto found = entry.metrics.find(name);
                fmt::print(" {:>14}", found == entry.metrics.end() ? "-" : fmt::format("{:.5g}", found->second));
            }
            fmt::print("  {}\n", entry.held ? (entry.limits.empty() ? "" : "held") : "FAILED");
        }
    }

    json test_json(size_t i) const {
        const report::Entry& entry = report_.entries[i];
        json limits = json::array(), worst = json::array();
        for (const report::Limit& limit : entry.limits)
            limits.push_back(
                {{"metric", limit.metric}, {"limit", limit.limit}, {"at_least", limit.at_least}, {"held", limit.held}});
        for (const Block& block : worst_[i])
            worst.push_back(
                {{"x", block.x + crop_.x}, {"y", block.y + crop_.y}, {"relative_squared_error", block.mean}});
        return {{"test", options_.tests[i]}, {"held", entry.held},   {"metrics", entry.metrics},  {"limits", limits},
                {"worst_blocks", worst},     {"notes", entry.notes}, {"exposure", entry.exposure}};
    }

    void write_json() const {
        if (options_.json.empty()) return;
        const ComparisonOptions& how = options_.comparison;
        json all = {{"tyndall_compare", 1},
                    {"reference", options_.reference},
                    {"width", reference_.radiance.width},
                    {"height", reference_.radiance.height},
                    {"settings",
                     {{"layer", options_.layer},
                      {"mask", options_.mask},
                      {"crop", crop_.width > 0 ? json{crop_.x, crop_.y, crop_.width, crop_.height} : json()},
                      {"tolerance", how.tolerance},
                      {"pixels_per_degree", how.pixels_per_degree},
                      {"exposure_stops", how.exposure_stops},
                      {"reference_noise", options_.noise},
                      {"significance", options_.significance > 0 ? options_.significance : how.significance}}},
                    {"tests", json::array()}};
        bool held = true;
        for (size_t i = 0; i < report_.entries.size(); ++i) {
            all["tests"].push_back(test_json(i));
            held = held && report_.entries[i].held;
        }
        all["held"] = held;
        const std::string text = all.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
        if (options_.json == "-")
            fmt::print("{}", text);
        else
            paths::write_file_atomically(options_.json, text);
    }

    const Options& options_;
    Rectangle crop_;
    std::vector<std::pair<std::string, double>> limits_;
    NoisyPicture reference_;
    Image whole_;  ///< the reference's size before it was cropped; without pixels
    Mask mask_;
    report::Report report_;
    std::vector<std::vector<Block>> worst_;
};

int run(const Options& options) {
    try {
        return Run(options).all();
    } catch (const Error& error) {
        std::fprintf(stderr, "tyndall: %s\n", error.what());
        return 2;
    }
}

}  // namespace

void add_compare(CLI::App& app, Command& command) {
    auto options = std::make_shared<Options>();
    CLI::App* sub = app.add_subcommand("compare", "Say how far pictures are from a reference");
    sub->add_option("reference", options->reference, "Scene-linear picture: EXR, HDR")->required();
    sub->add_option("tests", options->tests, "Pictures of its size, or a whole multiple of it")->required();
    sub->add_option("--metric", options->limits,
                    "Limit that must hold, such as relmse=0.01; docs/compare.md lists them")
        ->type_name("NAME=LIMIT")
        ->allow_extra_args(false);
    sub->add_option("--layer", options->layer, "Layer of the EXR files to compare; otherwise R G B");
    sub->add_option("--mask", options->mask, "Picture whose pixels count where they are not black");
    sub->add_option("--crop", options->crop, "Rectangle that counts, in the reference's pixels")->type_name("X,Y,W,H");
    sub->add_option("--exposure", options->comparison.exposure_stops,
                    "Stops above the exposure that makes the reference's 99.5th percentile white, for FLIP and SSIM")
        ->check(CLI::Range(-30, 30));
    sub->add_option("--ppd", options->comparison.pixels_per_degree, "Pixels per degree of the eye's view, for FLIP")
        ->check(CLI::Range(1.0, 1000.0))
        ->capture_default_str();
    sub->add_option("--tolerance", options->comparison.tolerance, "Relative error above which a pixel fails")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    sub->add_option("--significance", options->significance,
                    "Judge by a Z-test: fail when noise alone would differ so much with less than this probability")
        ->check(CLI::Range(1e-12, 0.5));
    sub->add_option("--reference-noise", options->noise,
                    "Standard deviation of the reference's pixels over their value, where it has no variance")
        ->check(CLI::Range(0.0, 10.0));
    sub->add_flag("--fast", options->fast, "Leave out HDR-FLIP");
    sub->add_option("--json", options->json, "File for the numbers; - prints them");
    sub->add_option("--report", options->report, "Folder for an HTML report");
    sub->add_option("--history", options->history, "File of the report's past runs; otherwise history.jsonl in it");
    sub->add_option("--kind", options->kind, "What the reference is, for the report")
        ->check(CLI::IsMember({"reference", "baseline", "variant"}))
        ->capture_default_str();
    sub->footer(
        "Exit code 1: a limit does not hold, or a test holds NaN or Inf. 2: something cannot be read or compared.\n\n"
        "  tyndall compare truth.exr half.exr full.exr --report out/report\n"
        "  tyndall compare truth.exr test.exr --metric relmse=0.01 --metric hdr_flip=0.05 --json numbers.json\n"
        "  tyndall compare traced_a.exr traced_b.exr --significance 0.01\n");
    sub->callback([options, &command] { command = [options] { return run(*options); }; });
}

}  // namespace tyndall
