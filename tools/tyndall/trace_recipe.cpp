#include "trace_recipe.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/reference_recipe.h"
#include "core/paths.h"

namespace tyndall {
namespace {

using Json = nlohmann::ordered_json;

/// Counted up when the tracer gives another picture of the same scene and settings, beyond noise.
constexpr int kTracerVersion = 1;

/// [name, hash of the content] of each file: where it lies does not matter.
Json content_of(std::vector<std::filesystem::path> files) {
    Json all = Json::array();
    for (const std::filesystem::path& file : files)
        all.push_back({file.filename().string(), content_hash(paths::read_file(file))});
    std::sort(all.begin(), all.end());
    return all;
}

}  // namespace

std::string trace_recipe(const Engine& engine, const std::string& camera, const reference::TraceSettings& settings) {
    std::vector<std::filesystem::path> files = engine.asset_files();
    files.push_back(engine.color().file());
    Json recipe;
    recipe["tracer"] = kTracerVersion;
    recipe["scene"] = engine.scene_path().filename().string();
    recipe["scene_hash"] = content_hash(engine.scene_text());
    recipe["files"] = content_of(std::move(files));
    recipe["camera"] = camera;
    recipe["size"] = {settings.size.x, settings.size.y};
    recipe["seed"] = settings.seed;
    recipe["batch"] = settings.batch;
    recipe["orders"] = {settings.min_order, settings.max_order};
    recipe["surfaces_scatter"] = settings.surfaces_scatter;
    recipe["media_scatter"] = settings.media_scatter;
    recipe["clamp"] = settings.clamp;
    recipe["components"] = settings.components;
    return recipe.dump();
}

}  // namespace tyndall
