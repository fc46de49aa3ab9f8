#pragma once
/// Which component types exist just now. Types come by name at run time, with the engine or a module, and leave with
/// it.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ecs/description.h"

namespace tyndall {

/// Names a component type within a registry; reused after the type has left.
enum class ComponentId : uint16_t { none = 0xffff };

/// The component types of a program: owned by it, shared by its worlds. Not thread-safe.
class ComponentRegistry {
 public:
    static constexpr size_t kMaximumTypes = 256;

    ComponentRegistry();
    ~ComponentRegistry();
    ComponentRegistry(const ComponentRegistry&) = delete;
    ComponentRegistry& operator=(const ComponentRegistry&) = delete;

    /// Registers T under T::kName. Throws Error when the name is taken.
    template <class T>
    ComponentId add(std::string owner = "engine") {
        return add(describe_struct<T>(std::string(T::kName)), std::move(owner));
    }
    ComponentId add(std::shared_ptr<const StructType> type, std::string owner);
    /// Forgets a type. Worlds must have dropped its components first (World::drop_components).
    void remove(ComponentId id);

    /// The id of a registered name, or none.
    [[nodiscard]] ComponentId find(std::string_view name) const;
    template <class T>
    [[nodiscard]] ComponentId find() const {
        return find(T::kName);
    }
    [[nodiscard]] const StructType& type(ComponentId id) const;
    /// "engine", or the module that brought it.
    [[nodiscard]] const std::string& owner(ComponentId id) const;
    /// All registered ids in order of registration.
    [[nodiscard]] std::span<const ComponentId> ids() const;
    /// All registered names, for suggestions.
    [[nodiscard]] std::vector<std::string> names() const;

 private:
    struct Implementation;
    std::unique_ptr<Implementation> self_;
};

}  // namespace tyndall
