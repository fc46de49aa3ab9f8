#pragma once
/// Entities and their components.
///
/// Storage is by archetype: entities with the same set of components share one table, a dense column per component, so
/// a view walks plain arrays. Columns belong to the engine and know a component only through its StructType; nothing of
/// a module is kept here but the bytes, which the module itself empties before it leaves (`drop_components`).
///
/// Changing structure while iterating (`create`, `destroy`, `add`, `remove` inside `each`) is defined: the change is
/// recorded and takes effect when the outermost `each` returns; until then iteration and `find` see the state before
/// it. A created entity's handle is alive at once.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "ecs/component_registry.h"

namespace tyndall {

/// A generational handle: stays dead after its entity was destroyed, even when the slot is used again.
struct Entity {
    uint32_t index = 0xffffffff;
    uint32_t generation = 0;
    bool operator==(const Entity&) const = default;
    explicit operator bool() const { return index != 0xffffffff; }
};

/// A set of entities with components, names and a hierarchy. Not thread-safe; views may be read from several threads
/// while nobody changes structure.
class World {
 public:
    /// `registry` must outlive the world.
    explicit World(ComponentRegistry& registry);
    ~World();
    World(const World&) = delete;
    World& operator=(const World&) = delete;
    [[nodiscard]] ComponentRegistry& registry() const;

    // Entities -------------------------------------------------------------------------------------------------------
    Entity create();
    /// Creates an entity that has all of these at once: the fast way.
    template <class... C>
    Entity create_with(C... components);
    /// Destroys the entity and all below it. A dead handle is ignored.
    void destroy(Entity entity);
    [[nodiscard]] bool alive(Entity entity) const;
    [[nodiscard]] size_t size() const;
    /// All living entities in order of creation (slots in use, by index).
    [[nodiscard]] std::vector<Entity> entities() const;

    // Names and hierarchy --------------------------------------------------------------------------------------------
    void set_name(Entity entity, std::string name);
    [[nodiscard]] const std::string& name(Entity entity) const;
    /// The first entity of that name, or a null handle.
    [[nodiscard]] Entity find_named(std::string_view name) const;
    /// A null `parent` makes a root. Returns false and changes nothing when that would make a cycle.
    bool set_parent(Entity child, Entity parent);
    [[nodiscard]] Entity parent(Entity entity) const;
    [[nodiscard]] std::span<const Entity> children(Entity entity) const;

    // Components -----------------------------------------------------------------------------------------------------
    /// Adds or replaces. T must be registered.
    template <class T>
    void add(Entity entity, T value = {});
    template <class T>
    void remove(Entity entity) {
        remove(entity, registry().template find<T>());
    }
    /// Null when the entity has none, is dead, or T is not registered. Valid until the next change of structure.
    template <class T>
    [[nodiscard]] T* find(Entity entity) {
        return static_cast<T*>(find(entity, registry().template find<T>()));
    }
    template <class T>
    [[nodiscard]] const T* find(Entity entity) const {
        return const_cast<World*>(this)->find<T>(entity);
    }

    /// The same by id, for code that knows types only by description. `add` default-constructs and returns the
    /// component (null while iterating, or when it is there already it is replaced); `value` is moved from when not
    /// null.
    void* add(Entity entity, ComponentId id, void* value = nullptr);
    void remove(Entity entity, ComponentId id);
    [[nodiscard]] void* find(Entity entity, ComponentId id);
    [[nodiscard]] const void* find(Entity entity, ComponentId id) const;
    /// The components of an entity, in order of registration.
    [[nodiscard]] std::vector<ComponentId> components(Entity entity) const;
    /// Removes the component from every entity and frees its columns; before its type leaves the registry.
    void drop_components(ComponentId id);

    /// Calls `f(Entity, C&...)` for each entity that has all of C (const C allowed), in dense storage order.
    template <class... C, class F>
    void each(F&& f);
    template <class... C, class F>
    void each(F&& f) const;
    /// Walks every entity with component `id`: for erased code.
    void each(ComponentId id, void (*f)(void* context, Entity entity, void* component), void* context);

    /// Grows with every structural change: caches compare it.
    [[nodiscard]] uint64_t version() const;

 private:
    // To be completed by the implementation: archetype tables, slots, command buffer.
};

}  // namespace tyndall
