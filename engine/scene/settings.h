#pragma once
/// Settings of the renderer and the modules: described structs by name, set by the scene's "render" object, `--set`, or
/// the UI.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ecs/description.h"

namespace tyndall {

/// A set of named settings objects. A scene writes them as "render": { "participating_media": { "resolution": "half" }
/// }.
class Settings {
 public:
    Settings();
    ~Settings();
    /// Adds T under T::kName with its defaults. Throws Error when the name is taken.
    template <class T>
    void add(std::string owner = "engine") {
        add(describe_struct<T>(std::string(T::kName)), std::move(owner));
    }
    void add(std::shared_ptr<const StructType> type, std::string owner);
    /// Destroys the settings of that name, if there are any: before the module that brought them leaves.
    void remove(std::string_view name);

    /// The settings of that type; they must have been added. The object stays where it is until it is removed.
    template <class T>
    [[nodiscard]] const T& get() const {
        return *static_cast<const T*>(find(T::kName));
    }
    template <class T>
    [[nodiscard]] T& get() {
        return *static_cast<T*>(find(T::kName));
    }
    [[nodiscard]] void* find(std::string_view name);
    [[nodiscard]] const void* find(std::string_view name) const;
    [[nodiscard]] const StructType* type(std::string_view name) const;
    /// Who added it: "engine" or a module; empty for an unknown name.
    [[nodiscard]] std::string owner(std::string_view name) const;
    /// All names in the order they were added.
    [[nodiscard]] std::vector<std::string> names() const;
    /// Changes when a value of a trivially copyable settings struct does: what was made from settings compares it each
    /// frame.
    [[nodiscard]] uint64_t fingerprint() const;
    /// Everything back to its defaults: before another scene is loaded.
    void reset();

 private:
    struct Implementation;
    std::unique_ptr<Implementation> self_;
};

}  // namespace tyndall
