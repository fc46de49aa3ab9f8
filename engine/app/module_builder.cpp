#include "app/module_builder.h"

#include <unistd.h>

#include <iterator>
#include <sstream>

#include "core/error.h"
#include "core/log.h"
#include "core/paths.h"

namespace tyndall {
namespace fs = std::filesystem;
namespace {

/// What is compiled into the library: shaders and captures are not.
bool is_source(const fs::path& file) {
    return file.extension() == ".cpp" || file.extension() == ".h" || file.filename() == "CMakeLists.txt";
}

/// The compiler's complaints without the build tool's progress.
std::string errors_of(const std::string& log) {
    std::istringstream in(log);
    std::string text;
    for (std::string line; std::getline(in, line);)
        if (line.find("error") != std::string::npos && !line.starts_with("ninja:")) text += line + "\n";
    return text.empty() ? log : text;
}

}  // namespace

ModuleBuilder::ModuleBuilder(fs::path build, fs::path sources)
    : build_(std::move(build)),
      sources_(std::move(sources)),
      log_(build_ / ("module_build_" + std::to_string(getpid()) + ".log")) {
    watch_.add(sources_);
}

ModuleBuilder::~ModuleBuilder() {
    process_.reset();
    std::error_code ignored;
    fs::remove(log_, ignored);
}

void ModuleBuilder::update() {
    if (building()) finish();
    for (const fs::path& file : watch_.changed()) {
        const fs::path inside = file.lexically_relative(sources_);
        if (is_source(file) && std::distance(inside.begin(), inside.end()) == 2) due_.insert(inside.begin()->string());
    }
    if (!building() && !due_.empty()) start(due_.extract(due_.begin()).value());
}

std::string ModuleBuilder::problems() const {
    std::string all;
    for (const auto& [module, text] : problems_)
        all += "module " + module + " does not build (the last good build runs on):\n" + text;
    return all;
}

void ModuleBuilder::start(const std::string& module) {
    log::info("building module {}", module);
    module_ = module;
    try {
        process_.emplace(std::vector<std::string>{"cmake", "--build", build_.string(), "--target", "module_" + module},
                         log_);
    } catch (const Error& error) {
        problems_[module] = std::string(error.what()) + "\n";
    }
}

void ModuleBuilder::finish() {
    const std::optional<ProcessEnd> end = process_->poll();
    if (!end) return;
    process_.reset();
    problems_.erase(module_);
    if (end->well()) return;
    try {
        problems_[module_] = errors_of(paths::read_file(log_));
    } catch (const Error& error) {
        problems_[module_] = std::string(error.what()) + "\n";
    }
    log::error("{}", problems());
}

}  // namespace tyndall
