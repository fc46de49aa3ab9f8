// profile: diffusion profiles of skin as Gaussians.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "commands.h"
#include "core/error.h"
#include "core/paths.h"
#include "measure/plot.h"
#include "physics/radial_profile.h"
#include "profile_choice.h"
#include "scene/field_reader.h"
#include "scene/field_writer.h"

namespace tyndall {
namespace {

constexpr float kMm = 1e-3f, kPerMm2 = 1e6f;

/// What a file says, as in the component `skin`.
struct ProfileFile {
    skin::ProfileChoice profile;
};

void describe(StructBuilder<ProfileFile>& d) {
    d.field("profile", &ProfileFile::profile, "How light spreads.", skin::profile_names());
}

skin::ProfileChoice read_profile(const std::string& file) {
    const JsonDocument document = parse_json(paths::read_file(file), file);
    const auto type = describe_struct<ProfileFile>("profile");
    ProfileFile read;
    std::vector<Diagnostic> wrong;
    Problems problems(document, wrong);
    if (document.root.find("profile"))
        read_struct(*type, &read, document.root, problems);
    else
        read_field(type->fields.front(), &read.profile, document.root, problems);
    if (!wrong.empty()) throw Error(wrong);
    return read.profile;
}

skin::ProfileChoice preset(const std::string& name) {
    const auto type = describe_struct<ProfileFile>("profile");
    const std::vector<std::string> names = skin::profile_names();
    const auto found = std::ranges::find(names, name);
    if (found == names.end())
        throw Error(Diagnostic{{}, "unknown profile '" + name + "'", join_names(names), nearest_name(name, names)});
    ProfileFile made;
    type->fields.front().choice_emplace(&made.profile, size_t(found - names.begin()));
    return made.profile;
}

/// With as many digits as a fit is worth.
float rounded(float value) {
    return std::stof(fmt::format("{:.4g}", value));
}

/// The profile as the choice `gaussians`: what can be pasted into a scene.
std::string as_gaussians(const physics::DiffusionProfile& profile) {
    skin::GaussiansProfile gaussians;
    for (const auto& [variance, w] : profile.lobes)
        gaussians.lobes.push_back({rounded(variance * kPerMm2), {rounded(w.x), rounded(w.y), rounded(w.z)}});
    const ProfileFile file{gaussians};
    return wrap_json(write_struct(*describe_struct<ProfileFile>("profile"), &file), 0, 0) + "\n";
}

void print_channels(const char* what, const glm::vec3& value, const char* note) {
    fmt::print("{:26}{:10.4f}{:10.4f}{:10.4f}  {}\n", what, value.x, value.y, value.z, note);
}

void print_figures(const skin::MadeProfile& made) {
    constexpr std::array<float, 5> kThin_mm{1.0f, 2.0f, 3.0f, 5.0f, 8.0f};
    fmt::print("{:26}{:>10}{:>10}{:>10}\n", "", "red", "green", "blue");
    for (const physics::DiffusionLobe& lobe : made.profile.lobes)
        print_channels(fmt::format("{:.4g} mm2", lobe.variance_m2 * kPerMm2).c_str(), lobe.weight, "weight");
    if (made.edge_error != glm::vec3(0.0f)) {  // others are Gaussians by themselves, and know no albedo
        print_channels("albedo", made.albedo, "of the light that has entered");
        print_channels("fit error", made.fit_error, "of r R(r), relative RMS");
        print_channels("edge error", made.edge_error, "of a lit half plane, RMS");
    }
    glm::vec3 width, mean(0.0f);
    for (const auto& [variance, weight] : made.profile.lobes)
        mean += weight * (std::sqrt(0.5f * std::numbers::pi_v<float> * variance) / kMm);
    print_channels("mean distance", mean, "mm");
    for (int c = 0; c < 3; ++c)
        width[c] = float(physics::edge_width([&](double x) { return double(made.profile.edge(float(x))[c]); })) / kMm;
    print_channels("edge, 10 % to 90 %", width, "mm");
    for (const float mm : kThin_mm)
        print_channels(fmt::format("through {:g} mm", mm).c_str(),
                       made.transmittance ? made.transmittance->at(mm * kMm) : made.profile.through(mm * kMm),
                       made.transmittance ? "of the light that has entered" : "by the profile alone (Jimenez 2010)");
}

std::string plot(const physics::DiffusionProfile& profile) {
    constexpr float kNear_mm = 0.02f, kFar_mm = 20.0f, kLeast_per_mm2 = 1e-7f;
    measure::Plot plot;
    plot.id = "profile";
    plot.title = "Light that leaves beside where it entered";
    plot.description = "Share per square millimetre over the distance, for red, green and blue.";
    plot.x_label = "distance, mm";
    plot.y_label = "share, 1/mm2";
    plot.front = false;
    // in the order of the plots' colours, which are blue, red and green
    for (const auto& [name, channel] : {std::pair("blue", 2), std::pair("red", 0), std::pair("green", 1)}) {
        measure::PlotSeries& series = plot.series.emplace_back();
        series.name = name;
        for (float mm = kNear_mm; mm < kFar_mm; mm *= 1.25f) {
            const float share = profile.at(mm * kMm)[channel] / kPerMm2;
            if (share > kLeast_per_mm2) series.points.push_back({double(mm), double(share), {}, {}, false});
        }
    }
    return measure::svg_of(plot);
}

int print_profile(const skin::ProfileChoice& choice, const std::string& out, const std::string& picture) {
    const auto made = skin::made_profile(choice);
    print_figures(*made);
    if (!picture.empty()) paths::write_file_atomically(picture, plot(made->profile));
    const std::string text = as_gaussians(made->profile);
    if (out.empty())
        fmt::print("\n{}", text);
    else
        paths::write_file_atomically(out, text);
    return 0;
}

}  // namespace

void add_profile(CLI::App& app, Command& command) {
    struct Options {
        std::string file, preset, out, plot;
    };
    const auto options = std::make_shared<Options>();
    CLI::App* profile = app.add_subcommand(
        "profile", "Prints a diffusion profile of the component skin as Gaussians, with its widths and its errors");
    CLI::Option* file = profile->add_option(
        "file", options->file, "JSON with a profile as the component has it: { \"layers\": { \"layers\": [...] } }");
    CLI::Option* named = profile->add_option("--preset", options->preset, "A kind of profile by its name: skin1");
    file->excludes(named);
    profile->add_option("--out", options->out, "Where to write the Gaussians as JSON; without it, they are printed");
    profile->add_option("--plot", options->plot, "Where to draw it: an SVG file");
    profile->callback([options, &command] {
        if (options->file.empty() && options->preset.empty())
            throw CLI::RequiredError("a file or --preset, one of " + join_names(skin::profile_names()));
        command = [options] {
            return print_profile(options->file.empty() ? preset(options->preset) : read_profile(options->file),
                                 options->out, options->plot);
        };
    });
}

}  // namespace tyndall
