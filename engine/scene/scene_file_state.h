#pragma once
/// What a SceneFile keeps, and the parts of its work that stand in files of their own.

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "scene/json_text.h"
#include "scene/scene_file.h"

namespace tyndall {

struct SceneFile::Implementation {
    JsonDocument document;
    std::vector<Entity> entities;  ///< those of the text in its order; empty before it was instantiated
    /// Components (item of "entities", key) that no registered type could read: the world does not have them, and
    /// saving must not take that for their removal.
    std::set<std::pair<size_t, std::string>> verbatim;
};

/// The document of a text whose structure is right. Throws Error with all its problems.
[[nodiscard]] JsonDocument parse_scene(std::string text, std::string file_name);

/// Modules that "modules" lists, that are not among the `loaded` ones, and that have brought neither a component nor
/// settings.
[[nodiscard]] std::vector<std::string> missing_modules(const JsonDocument& document, const ComponentRegistry& registry,
                                                       const Settings& settings, std::span<const std::string> loaded);

/// Components and settings against their descriptions.
[[nodiscard]] std::vector<Diagnostic> validate_scene(const JsonDocument& document, const ComponentRegistry& registry,
                                                     const Settings& settings, std::span<const std::string> loaded);

/// Reads the "render" object into settings and options.
void read_render(const JsonDocument& document, Settings& settings, RenderOptions& options);

/// Turns entities whose transforms were written with "look_at", once all parents are set.
class LookAts {
 public:
    void add(Entity entity, const glm::vec3& target) { targets_.emplace_back(entity, target); }
    void resolve(World& world);

 private:
    std::vector<std::pair<Entity, glm::vec3>> targets_;
};

/// The text of the document after the world's, the settings' and the options' changes, and the entities in its order.
struct UpdatedScene {
    std::string text;
    std::vector<Entity> entities;
    std::set<std::pair<size_t, std::string>> verbatim;
};
[[nodiscard]] UpdatedScene update_scene(const SceneFile::Implementation& state, const World& world,
                                        const Settings& settings, const RenderOptions& options);

/// The text after the value at `pointer` was replaced or added.
[[nodiscard]] std::string set_in_scene(const JsonDocument& document, std::string_view pointer,
                                       std::string_view json_value);

}  // namespace tyndall
