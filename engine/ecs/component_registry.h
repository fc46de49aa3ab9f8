#pragma once
/// Which component types exist just now. Types come by name at run time, with the engine or a module, and leave with
/// it.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "ecs/description.h"

namespace tyndall {

/// Names a component type within a registry; reused after the type has left.
enum class ComponentId : uint16_t { none = 0xffff };

namespace detail {
/// FNV-1a, 64 bits; never 0. Known at compile time for a type's kName.
constexpr uint64_t name_hash(std::string_view name) {
    uint64_t hash = 0xcbf29ce484222325u;
    for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    return hash == 0 ? 1 : hash;
}
}  // namespace detail

/// The component types of a program: owned by it, shared by its worlds. Not thread-safe.
class ComponentRegistry {
 public:
    static constexpr size_t kMaximumTypes = 256;

    ComponentRegistry();
    ~ComponentRegistry();
    ComponentRegistry(const ComponentRegistry&) = delete;
    ComponentRegistry& operator=(const ComponentRegistry&) = delete;

    /// Registers T under T::kName. Throws Error when the name is taken or kMaximumTypes are registered.
    template <class T>
    ComponentId add(std::string owner = "engine") {
        static_assert(std::is_nothrow_move_constructible_v<T>, "storage moves components: that must not throw");
        return add(describe_struct<T>(std::string(T::kName)), std::move(owner));
    }
    ComponentId add(std::shared_ptr<const StructType> type, std::string owner);
    /// Forgets a type. Worlds must have dropped its components first (World::drop_components).
    void remove(ComponentId id);

    /// The id of a registered name, or none.
    [[nodiscard]] ComponentId find(std::string_view name) const;
    template <class T>
    [[nodiscard]] ComponentId find() const {
        constexpr uint64_t hash = detail::name_hash(T::kName);
        return find_hash(hash);
    }
    /// Throws Error for an id that is not registered, as does `owner`.
    [[nodiscard]] const StructType& type(ComponentId id) const;
    /// "engine", or the module that brought it.
    [[nodiscard]] const std::string& owner(ComponentId id) const;
    /// All registered ids in order of registration.
    [[nodiscard]] std::span<const ComponentId> ids() const;
    /// All registered names, for suggestions.
    [[nodiscard]] std::vector<std::string> names() const;

 private:
    struct Entry {
        std::shared_ptr<const StructType> type;
        std::string owner;
    };
    struct Bucket {
        uint64_t hash = 0;  ///< 0 = empty
        ComponentId id = ComponentId::none;
    };
    // Ids are looked up by hash each time rather than kept in a static of a template: such a static would live in the
    // module that instantiated it, and go stale when modules come and go.
    static constexpr size_t kBuckets = 2 * kMaximumTypes;

    [[nodiscard]] ComponentId find_hash(uint64_t hash) const {
        for (size_t i = hash % kBuckets;; i = (i + 1) % kBuckets) {
            if (buckets_[i].hash == hash) return buckets_[i].id;
            if (buckets_[i].hash == 0) return ComponentId::none;
        }
    }
    void insert(uint64_t hash, ComponentId id);
    [[nodiscard]] const Entry& entry(ComponentId id) const;

    std::array<Bucket, kBuckets> buckets_;
    std::vector<Entry> entries_;    ///< by id; a null type marks a free id
    std::vector<ComponentId> ids_;  ///< in order of registration
};

}  // namespace tyndall
