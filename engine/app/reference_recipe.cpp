#include "app/reference_recipe.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "app/engine.h"
#include "core/paths.h"
#include "scene/scene_file.h"

namespace tyndall {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::json;  // its keys are sorted: their order in a file does not matter

/// The content of the files that a scene names, and that the JSON files among them name.
class NamedFiles {
 public:
    void add_from(const Json& value, const fs::path& folder) {
        if (value.is_string()) add(value.get<std::string>(), folder);
        for (const Json& item : value)
            if (item.is_structured() || (item.is_string() && value.is_structured())) add_from(item, folder);
    }
    /// Name to hash.
    [[nodiscard]] const Json& hashes() const { return hashes_; }

 private:
    void add(const std::string& name, const fs::path& folder) {
        constexpr std::string_view kAssets = "assets:";
        const fs::path file =
            name.starts_with(kAssets) ? paths::root() / "assets" / name.substr(kAssets.size()) : folder / name;
        std::error_code none;
        if (name.size() > 255 || !fs::is_regular_file(file, none) || !seen_.insert(file).second) return;
        const std::string content = paths::read_file(file);
        hashes_[name] = content_hash(content);
        if (file.extension() != ".json" && file.extension() != ".gltf") return;
        if (const Json inner = Json::parse(content, nullptr, false); !inner.is_discarded())
            add_from(inner, file.parent_path());
    }

    Json hashes_ = Json::object();
    std::set<fs::path> seen_;
};

}  // namespace

std::string content_hash(std::string_view content) {
    uint64_t hash = 0xcbf29ce484222325ull;
    for (const char c : content) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
    return fmt::format("{:016x}", hash);
}

std::vector<std::string> changes_of(const CaptureFile& capture, const TracedReference& reference) {
    std::vector<std::string> changes = capture.variant_of(reference).set;
    changes.insert(changes.end(), reference.set.begin(), reference.set.end());
    return changes;
}

glm::ivec2 size_of(const CaptureFile& capture, const TracedReference& reference) {
    return reference.size.x > 0.0f ? reference.size : capture.size;
}

std::string recipe_of(const CaptureFile& capture, const TracedReference& reference) {
    const fs::path file = capture.file.parent_path() / capture.scene;
    SceneFile scene = SceneFile::load(file);
    for (const std::string& change : changes_of(capture, reference)) {
        const auto [pointer, value] = split_assignment(change);
        scene.set(pointer, value);
    }
    Json content = Json::parse(scene.text());
    std::string camera = capture.camera_of(reference);
    if (camera.empty()) camera = content.value(Json::json_pointer("/render/camera"), "");
    content.erase("render");
    content.erase("description");
    NamedFiles files;
    files.add_from(content, file.parent_path());
    const glm::ivec2 size = size_of(capture, reference);
    const int highest = reference.single_scattering ? 1 : reference.orders.empty() ? -1 : reference.orders[1];
    return Json{{"scene", content_hash(content.dump())},
                {"files", files.hashes()},
                {"camera", camera},
                {"size", {size.x, size.y}},
                {"samples", reference.samples},
                {"noise", std::round(static_cast<double>(reference.noise) * 1e6) / 1e6},
                {"seed", reference.seed},
                {"orders", {reference.orders.empty() ? 0 : reference.orders[0], highest}},
                {"surfaces_scatter", !reference.no_surfaces},
                {"media_scatter", !reference.no_media}}
        .dump();
}

std::string difference_of_recipes(const std::string& stored, const std::string& wanted) {
    const Json was = Json::parse(stored, nullptr, false), now = Json::parse(wanted);
    if (!was.is_object()) return "not a reference that was traced for a capture: it has no recipe";
    std::string differences;
    for (const auto& [key, value] : now.items()) {
        const Json before = was.value(key, Json());
        if (before == value) continue;
        const std::string what = key == "scene" || key == "files"
                                     ? key + " changed"
                                     : fmt::format("{} was {}, is {}", key, before.dump(), value.dump());
        differences += (differences.empty() ? "" : "; ") + what;
    }
    return differences.empty() ? "" : "the reference was traced from another recipe: " + differences;
}

}  // namespace tyndall
