// schema, validate, modules, info: what needs no picture.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "commands.h"
#include "core/build_info.h"
#include "core/error.h"
#include "core/paths.h"
#include "platform/context.h"

namespace tyndall {
namespace {

void load_all_modules(Engine& engine) {
    for (const std::string& name : engine.modules().available()) engine.modules().load(name);
}

int print_schema(bool manual) {
    Engine engine(false);
    load_all_modules(engine);
    fmt::print("{}", manual ? component_manual(engine.registry(), engine.settings())
                            : scene_schema(engine.registry(), engine.settings()));
    return 0;
}

int validate(const std::vector<std::string>& files) {
    Engine engine(false);
    int bad = 0;
    for (const std::string& file : files) {
        try {
            engine.load_scene(file);
            fmt::print("{}: right\n", file);
        } catch (const Error& error) {
            ++bad;
            fmt::print(stderr, "{}\n", error.what());
        }
    }
    return bad > 0 ? 1 : 0;
}

void print_list(const char* title, const std::vector<std::string>& names) {
    if (!names.empty()) fmt::print("    {:12} {}\n", title, fmt::join(names, ", "));
}

int list_modules() {
    Engine engine(false);
    load_all_modules(engine);
    bool all_well = true;
    for (const ModuleReport& module : engine.modules().reports()) {
        fmt::print("{} {}: {}\n", module.name, module.version, name_of(module.state));
        if (!module.summary.empty()) fmt::print("    {}\n", module.summary);
        if (!module.problem.empty()) fmt::print("    {:12} {}\n", "problem", module.problem);
        print_list("depends on", module.depends);
        print_list("components", module.components);
        print_list("settings", module.settings);
        print_list("passes", module.passes);
        print_list("seams", module.seams);
        all_well = all_well && module.state == ModuleState::loaded;
    }
    if (engine.modules().available().empty()) fmt::print("no modules in {}\n", (paths::build() / "modules").string());
    return all_well ? 0 : 1;
}

int info() {
    fmt::print("tyndall {} ({}), {} {}\n", build_info().version, build_info().revision, build_info().compiler,
               build_info().preset);
    const auto context = platform::create_headless_context();
    fmt::print("{}\n", context->gl_info().text());
    const ColorConfig color;
    fmt::print("colour    {} (working space {})\n", color.file().string(), color.working_space());
    for (const std::string& display : color.displays())
        fmt::print("display   {}: {}\n", display, fmt::join(color.views(display), ", "));
    return 0;
}

}  // namespace

void add_schema(CLI::App& app, Command& command) {
    auto manual = std::make_shared<bool>(false);
    CLI::App* sub =
        app.add_subcommand("schema", "Print the JSON Schema of scene files, for editors that complete and check");
    sub->add_flag("--manual", *manual, "Print the components' manual as Markdown instead");
    sub->callback([manual, &command] { command = [manual] { return print_schema(*manual); }; });
}

void add_validate(CLI::App& app, Command& command) {
    auto files = std::make_shared<std::vector<std::string>>();
    CLI::App* sub = app.add_subcommand("validate", "Check scene files and print every problem");
    sub->add_option("files", *files, "Scene files")->required();
    sub->footer(
        "Problems come as FILE:LINE:COLUMN: /pointer: what is wrong (expected ...). Exit code 1: there are any.\n"
        "Files that a scene names are not opened: 'tyndall capture' does that.");
    sub->callback([files, &command] { command = [files] { return validate(*files); }; });
}

void add_modules(CLI::App& app, Command& command) {
    app.add_subcommand("modules", "List the modules: state, components, passes")->callback([&command] {
        command = list_modules;
    });
}

void add_info(CLI::App& app, Command& command) {
    app.add_subcommand("info", "Print versions, the GL driver and the colour configuration")->callback([&command] {
        command = info;
    });
}

}  // namespace tyndall
