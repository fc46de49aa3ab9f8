// mie: phase functions of water droplets.

#include <fmt/format.h>

#include <cstdio>

#include "commands.h"
#include "core/error.h"
#include "core/paths.h"
#include "mie/mie_table.h"

namespace tyndall {
namespace {

int write_table(const mie::DropletCloud& cloud, const std::string& out) {
    const mie::DropletTable table = mie::droplet_table(cloud);
    const std::string text = mie::table_text(table, cloud);
    if (out.empty()) {
        std::fputs(text.c_str(), stdout);
        return 0;
    }
    paths::write_file_atomically(out, text);
    fmt::print("{}: {} angles, mean cosine {:.4f} {:.4f} {:.4f}, extinction efficiency {:.3f} {:.3f} {:.3f}\n", out,
               table.values.size(), table.mean_cosine.x, table.mean_cosine.y, table.mean_cosine.z, table.efficiency.x,
               table.efficiency.y, table.efficiency.z);
    return 0;
}

}  // namespace

void add_mie(CLI::App& app, Command& command) {
    struct Options {
        mie::DropletCloud cloud;
        std::string out;
    };
    const auto options = std::make_shared<Options>();
    CLI::App* mie = app.add_subcommand(
        "mie", "Computes the phase function of water droplets by the Mie series, for `tabulated` phases of media");
    mie->add_option("--radius-um", options->cloud.radius_um, "Effective radius of the droplets")
        ->check(CLI::Range(0.05, 2000.0))
        ->capture_default_str();
    mie->add_option("--variance", options->cloud.variance, "Effective variance of the sizes; 0 = all alike")
        ->check(CLI::Range(0.0, 0.33))
        ->capture_default_str();
    mie->add_option("--sizes", options->cloud.sizes, "Radii to sum over")
        ->check(CLI::Range(1, 10000))
        ->capture_default_str();
    mie->add_option("--wavelengths", options->cloud.wavelengths, "Wavelengths to sum over")
        ->check(CLI::Range(3, 500))
        ->capture_default_str();
    mie->add_option("--step-deg", options->cloud.step_deg,
                    "Between the table's angles; values are means over that width")
        ->check(CLI::Range(0.01, 5.0))
        ->capture_default_str();
    mie->add_option("--out", options->out, "The file to write; without it, the table is printed");
    mie->callback([options, &command] { command = [options] { return write_table(options->cloud, options->out); }; });
}

}  // namespace tyndall
