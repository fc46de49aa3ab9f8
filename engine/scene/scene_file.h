#pragma once
/// Scene files: JSON to World and back, without losing anything a user wrote.

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "ecs/world.h"
#include "scene/settings.h"

namespace tyndall {

/// The top-level "render" keys that are the engine's own; all others name settings.
struct RenderOptions {
    std::string path = "deferred";  ///< "deferred" or "light_pre_pass"
    std::string display;            ///< OCIO display; empty = the config's default
    std::string view;               ///< OCIO view; empty = the display's default
    std::string camera;             ///< entity with a camera; empty = the first
};

/// A scene's text and what was read from it.
///
/// The text is kept: saving an untouched scene changes no byte, and a changed field changes only its own text.
/// Components whose type is not registered are kept verbatim and written again. One object serves one World.
class SceneFile {
 public:
    SceneFile();
    ~SceneFile();
    SceneFile(SceneFile&&) noexcept;
    SceneFile& operator=(SceneFile&&) noexcept;

    /// Parses and checks the structure only. Throws Error with every problem: line, column, pointer.
    static SceneFile parse(std::string text, std::string file_name);
    static SceneFile load(const std::filesystem::path& file);

    /// Replaces the value at a JSON pointer by a JSON text before it is instantiated (`capture --set
    /// /entities/2/medium/...=0.5`);
    /// "/entities/NAME/..." names an entity ('/' in it is written ~1). Keys that an object lacks are added; a value
    /// that is a plain word need not be quoted. Throws Error for a pointer that does not lead anywhere.
    void set(std::string_view pointer, std::string_view json_value);

    /// Names from "modules".
    [[nodiscard]] std::vector<std::string> modules() const;
    /// Checks everything against the registered descriptions; empty when it is right. What has no description may
    /// belong to a module that is absent, if the text lists one: neither in `loaded` nor the owner of anything
    /// registered.
    [[nodiscard]] std::vector<Diagnostic> validate(const ComponentRegistry& registry, const Settings& settings,
                                                   std::span<const std::string> loaded = {}) const;
    /// Makes the entities, settings (over the values they have) and options. Throws Error with all of `validate`'s
    /// problems and then changes nothing.
    void instantiate(World& world, Settings& settings, RenderOptions& options,
                     std::span<const std::string> loaded = {});
    /// Gives the entities those components of the text whose type was not registered at `instantiate` and is now: after
    /// a module was loaded late.
    void adopt(World& world);
    /// Takes the world's changes into the text: edited fields, added and removed components and entities. Entities with
    /// the component "transient", and those below them, are not saved. Throws Error when an entity's parent has no name
    /// of its own that the text could say.
    void update(const World& world, const Settings& settings, const RenderOptions& options);
    [[nodiscard]] const std::string& text() const;
    /// Writes the text atomically.
    void save(const std::filesystem::path& file) const;

    /// Where a component is in the file, for messages about it after loading ("asset not found").
    [[nodiscard]] SourceLocation location(Entity entity, std::string_view component) const;

    struct Implementation;

 private:
    std::unique_ptr<Implementation> self_;
};

/// Components of one entity as JSON text and back, through their descriptions: module reload, undo, copy and paste.
[[nodiscard]] std::string component_to_json(const StructType& type, const void* component);
/// Missing fields keep their defaults; unknown ones are returned, not lost. Problems are appended to `problems`.
std::string component_from_json(const StructType& type, void* component, std::string_view json,
                                std::vector<Diagnostic>& problems);

/// A JSON Schema (2020-12 subset that editors accept) of scene files for these descriptions.
[[nodiscard]] std::string scene_schema(const ComponentRegistry& registry, const Settings& settings);

/// The manual of all components and settings as Markdown: a table of fields each, made from the descriptions.
[[nodiscard]] std::string component_manual(const ComponentRegistry& registry, const Settings& settings);

}  // namespace tyndall
