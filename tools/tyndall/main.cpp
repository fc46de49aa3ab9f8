// tyndall: play, capture, bench, trace, merge, compare, measure, schema, validate, modules, mie, profile, farm, info.

#include <cstdio>

#include "commands.h"
#include "core/error.h"
#include "core/log.h"

using namespace tyndall;

namespace {

int run(int argc, char** argv) {
    CLI::App app(
        "Tyndall: light scattering in real time.\n"
        "Scenes are JSON files (docs/scene_format.md); assets/chapel/chapel.json is the sample level.");
    app.name("tyndall");
    app.require_subcommand(1);
    app.footer(
        "tyndall COMMAND --help says more. The environment: TYNDALL_LOG=debug|info|warning|error, OCIO, TYNDALL_ROOT.");
    Command command;
    for (const auto& add : {add_play, add_capture, add_bench, add_trace, add_merge, add_compare, add_measure,
                            add_schema, add_validate, add_modules, add_mie, add_profile, add_farm, add_info})
        add(app, command);
    CLI11_PARSE(app, argc, argv);
    return command();
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const Error& error) {
        std::fprintf(stderr, "tyndall: %s\n", error.what());
    } catch (const std::exception& error) {
        std::fprintf(stderr, "tyndall: %s\n", error.what());
    }
    return 1;
}
