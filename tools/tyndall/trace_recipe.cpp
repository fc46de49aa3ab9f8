#include "trace_recipe.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace tyndall {
namespace {

uint64_t fnv1a(std::string_view text) {
    uint64_t hash = 0xcbf29ce484222325ull;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
    return hash;
}

}  // namespace

std::string trace_recipe(Engine& engine, const std::string& camera, const reference::TraceSettings& settings) {
    nlohmann::ordered_json recipe;
    recipe["scene"] = engine.scene_path().filename().string();
    recipe["scene_hash"] = fmt::format("{:016x}", fnv1a(engine.scene_text()));
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
