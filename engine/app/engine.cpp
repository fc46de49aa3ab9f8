#include "app/engine.h"

#include <malloc.h>

#include <algorithm>

#include "core/log.h"
#include "core/paths.h"
#include "render/image_settings.h"
#include "scene/components.h"

namespace tyndall {
namespace fs = std::filesystem;
std::pair<std::string, std::string> split_assignment(const std::string& text) {
    const size_t equals = text.find('=');
    if (equals == std::string::npos || !text.starts_with('/'))
        throw Error("'" + text +
                    "' is no assignment (expected /json/pointer=value, such as /render/path=\"deferred\")");
    return {text.substr(0, equals), text.substr(equals + 1)};
}

Engine::Engine(bool rendering, const fs::path& ocio) : color_(ocio), assets_(color_, paths::root() / "assets") {
    register_engine_components(registry_, extractors_);
    if (rendering)
        renderer_ = std::make_unique<Renderer>(color_, settings_);
    else
        settings_.add<ImageSettings>();  // what a renderer would add, so that scenes can be checked and described
    modules_ =
        std::make_unique<ModuleManager>(ModuleHost{registry_, extractors_, settings_, {&world_}, renderer_.get()},
                                        paths::build() / "modules", paths::root() / "modules");
    watch_.add(color_.file());
}

Engine::~Engine() {
    if (renderer_) renderer_->show({});  // a module's target may be on show
    scene_.clear();
    modules_.reset();  // before the renderer and the world, where modules have things
}

namespace {

/// Errors name the pointer, also those that are about the value alone.
void apply(const Assignments& changes, SceneFile& scene) {
    for (const auto& [pointer, value] : changes) {
        try {
            scene.set(pointer, value);
        } catch (Error& error) {
            if (std::string_view(error.what()).find(pointer) == std::string_view::npos) error.within(pointer);
            throw;
        }
    }
}

}  // namespace

void Engine::load_scene(const fs::path& file, const Assignments& changes) {
    SceneFile next = SceneFile::load(file);
    apply(changes, next);
    const std::vector<std::string> before = modules_->in_use();
    use_modules(next.modules());
    if (std::vector<Diagnostic> problems = next.validate(registry_, settings_, modules_->in_use()); !problems.empty()) {
        use_modules(before);
        for (Diagnostic& problem : problems)
            if (problem.where.file.empty()) problem.where.file = file.string();
        throw Error(std::move(problems));
    }
    replace_world(std::move(next), file);
    changes_ = changes;
}

/// Modules that leave keep what the world had of theirs until they come back.
void Engine::use_modules(const std::vector<std::string>& wanted) {
    if (renderer_ && wanted != modules_->in_use()) renderer_->show({});
    scene_.clear();  // materials that a module's extractor made are freed by code of the module
    for (const ModuleReport& report : modules_->reports())
        if (std::ranges::find(wanted, report.name) == wanted.end()) modules_->unload(report.name);
    for (const std::string& name : wanted) modules_->load(name);
}

void Engine::reload_scene() {
    load_scene(scene_path_, changes_);
}

void Engine::save_scene(const fs::path& file) {
    scene_file_.update(world_, settings_, options_);
    scene_file_.save(file);
}

void Engine::replace_world(SceneFile next, const fs::path& file) {
    // From the last to the first: freed places are taken again in the old order, so that a scene loads the same each
    // time.
    const std::vector<Entity> leaving = world_.entities();
    for (auto entity = leaving.rbegin(); entity != leaving.rend(); ++entity) world_.destroy(*entity);
    settings_.reset();
    options_ = {};
    assets_.set_base(fs::absolute(file).parent_path());
    next.instantiate(world_, settings_, options_, modules_->in_use());
    scene_camera_ = options_.camera;
    scene_file_ = std::move(next);
    if (scene_path_ != file) {
        watch_.remove(scene_path_);
        watch_.add(file);
    }
    scene_path_ = file;
    unmade_.clear();
    restart_clock();
    apply_options();
    extract();  // loads the assets now; what decoding them needed goes back before the GPU's copies are made
    malloc_trim(0);
}

void Engine::apply_options() {
    if (!renderer_) return;
    renderer_->set_path(options_.path);
    renderer_->set_display(options_.display, options_.view);
}

void Engine::restart_clock() {
    time_s_ = 0.0;
    frame_ = 0;
    cut_ = true;
}

const RenderScene& Engine::extract() {
    scene_.clear();
    scene_.time_s = time_s_;
    scene_.frame = frame_;
    scene_.camera_cut = cut_;
    for (const ExtractionProblem& problem : extractors_.extract(world_, assets_, options_.camera, scene_)) {
        unmade_ = Diagnostic{scene_file_.location(problem.entity, problem.component), problem.text}.text();
        log::error("{}", unmade_);
    }
    return scene_;
}

void Engine::frame(double seconds, glm::ivec2 size, const std::optional<View>& view) {
    time_s_ += seconds;
    extract();
    if (view) {
        scene_.camera.transform = view->camera;
        scene_.camera.ev100 += view->ev_offset;
    }
    renderer_->render(scene_, size);
    cut_ = false;
    ++frame_;
}

void Engine::reload_changed() {
    scene_.clear();                                                      // as in use_modules
    if (!modules_->reload_changed().empty()) scene_file_.adopt(world_);  // what waited in the text for a module
    assets_.reload_changed();
    if (renderer_) renderer_->reload_changed();
    for (const fs::path& file : watch_.changed()) {
        if (file == color_.file()) reload_color();
        if (file == scene_path_) reload_changed_scene();
    }
}

void Engine::reload_color() {
    color_problem_.clear();
    try {
        color_ = ColorConfig(color_.file());
        if (renderer_) renderer_->color_changed();
        log::info("colour configuration reloaded");
    } catch (const Error& error) {
        log::error("{}", color_problem_ = error.what());
    }
}

void Engine::reload_changed_scene() {
    scene_problem_.clear();
    try {
        const std::string camera = options_.camera;
        reload_scene();
        options_.camera = camera;
        log::info("scene reloaded");
    } catch (const Error& error) {
        log::error("{}", scene_problem_ = error.what());
    }
}

std::string Engine::problems() const {
    std::string all;
    const auto add = [&](const std::string& text) {
        if (!text.empty()) all += text + "\n";
    };
    for (const ModuleReport& report : modules_->reports())
        if (!report.problem.empty()) add("module " + report.name + ": " + report.problem);
    if (renderer_) add(renderer_->problems());
    add(scene_problem_);
    add(color_problem_);
    return all;
}

std::vector<std::string> Engine::cameras() {
    std::vector<std::string> names;
    for (const Entity entity : world_.entities())
        if (world_.find<CameraComponent>(entity)) names.push_back(world_.name(entity));
    return names;
}

void Engine::select_camera(const std::string& name) {
    const std::vector<std::string> known = cameras();
    if (!name.empty() && std::find(known.begin(), known.end(), name) == known.end())
        throw Error(Diagnostic{{scene_path_.string()},
                               "no camera is called '" + name + "'",
                               "an entity with a camera",
                               nearest_name(name, known)});
    options_.camera = name.empty() ? scene_camera_ : name;
    cut_ = true;
}

}  // namespace tyndall
