#pragma once
/// Entities and their components.
///
/// Storage is by archetype: entities with the same set of components share one table, a dense column per component, so
/// a view walks plain arrays. Columns belong to the engine and know a component only through its StructType; nothing of
/// a module is kept here but the bytes, which the module itself empties before it leaves (`drop_components`).
///
/// Changing structure while iterating (`create`, `destroy`, `add`, `remove` inside `each`) is defined: the change is
/// recorded and takes effect when the outermost `each` returns; until then iteration and `find` see the state before
/// it. A created entity's handle is alive at once. Names and parents change at once. A callback that throws ends the
/// iteration; what it recorded until then takes effect.

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ecs/array_memory.h"
#include "ecs/command_buffer.h"
#include "ecs/component_registry.h"
#include "ecs/entity.h"
#include "ecs/hierarchy.h"
#include "ecs/names.h"
#include "ecs/table.h"

namespace tyndall {

/// A set of entities with components, names and a hierarchy. Not thread-safe; views may be read from several threads
/// while nobody changes structure.
class World {
 public:
    /// `registry` must outlive the world.
    explicit World(ComponentRegistry& registry);
    ~World();
    World(const World&) = delete;
    World& operator=(const World&) = delete;
    [[nodiscard]] ComponentRegistry& registry() const { return registry_; }

    // Entities -------------------------------------------------------------------------------------------------------
    Entity create();
    /// Creates an entity that has all of these at once: the fast way.
    template <class... C>
    Entity create_with(C... components);
    /// Destroys the entity and all below it. A dead handle is ignored.
    void destroy(Entity entity);
    [[nodiscard]] bool alive(Entity entity) const {
        return entity.index < slots_.size() && slots_[entity.index].generation == entity.generation &&
               slots_[entity.index].table != kFree;
    }
    /// How many entities live.
    [[nodiscard]] size_t size() const { return size_; }
    /// All living entities by index: in order of creation as long as no slot was used again.
    [[nodiscard]] std::vector<Entity> entities() const;

    // Names and hierarchy --------------------------------------------------------------------------------------------
    /// Several entities may share a name; an empty name is none. A dead handle is ignored.
    void set_name(Entity entity, std::string name);
    /// Empty for a dead handle or one without a name.
    [[nodiscard]] const std::string& name(Entity entity) const;
    /// The first entity (by index) of that name, or a null handle.
    [[nodiscard]] Entity find_named(std::string_view name) const;
    /// A null `parent` makes a root. Returns false and changes nothing when that would make a cycle or
    /// one of them is dead.
    bool set_parent(Entity child, Entity parent);
    [[nodiscard]] Entity parent(Entity entity) const;
    [[nodiscard]] std::span<const Entity> children(Entity entity) const;

    // Components -----------------------------------------------------------------------------------------------------
    /// Adds or replaces; nothing happens to a dead entity. Throws Error when T is not registered.
    template <class T>
    void add(Entity entity, T value = {});
    /// Nothing happens when there is none.
    template <class T>
    void remove(Entity entity) {
        remove(entity, registry_.find<T>());
    }
    /// Null when the entity has none, is dead, or T is not registered. Valid until the next change of structure.
    template <class T>
    [[nodiscard]] T* find(Entity entity) {
        return static_cast<T*>(find(entity, registry_.find<T>()));
    }
    template <class T>
    [[nodiscard]] const T* find(Entity entity) const {
        return const_cast<World*>(this)->find<T>(entity);
    }

    /// The same by id, for code that knows types only by description. `add` default-constructs and returns the
    /// component, or replaces it when it is there already; `value` is moved from when not null. Null while iterating
    /// or when the entity is dead. Throws Error when `id` is not registered.
    void* add(Entity entity, ComponentId id, void* value = nullptr);
    void remove(Entity entity, ComponentId id);
    [[nodiscard]] void* find(Entity entity, ComponentId id);
    [[nodiscard]] const void* find(Entity entity, ComponentId id) const;
    /// The components of an entity, in order of registration.
    [[nodiscard]] std::vector<ComponentId> components(Entity entity) const;
    /// Removes the component from every entity and frees its columns; before its type leaves the registry. Throws
    /// Error while iterating.
    void drop_components(ComponentId id);

    /// Calls `f(Entity, C&...)` for each entity that has all of C (const C allowed), in dense storage order. A type
    /// that is not registered is one that nobody has.
    template <class... C, class F>
    void each(F&& f);
    template <class... C, class F>
    void each(F&& f) const;
    /// Walks every entity with component `id`: for erased code.
    void each(ComponentId id, void (*f)(void* context, Entity entity, void* component), void* context);

    /// Grows with every structural change: caches compare it.
    [[nodiscard]] uint64_t version() const { return version_; }

 private:
    // Values of Slot::table for slots that lie in no table.
    static constexpr uint32_t kFree = 0xffffffff;
    static constexpr uint32_t kPending = 0xfffffffe;  ///< created while iterating

    struct Slot {
        uint32_t generation = 0;
        uint32_t table = kFree;
        uint32_t row = 0;  ///< of a free slot: the next free slot, or kFree
    };

    /// While one lives, structure stays as it is; the end of the outermost applies what was recorded.
    class Iteration {
     public:
        explicit Iteration(World& world) : world_(world) { world_.iterations_.fetch_add(1, std::memory_order_relaxed); }
        ~Iteration() {
            if (world_.iterations_.fetch_sub(1, std::memory_order_acq_rel) == 1 && !world_.commands_.empty())
                world_.apply();
        }
        Iteration(const Iteration&) = delete;
        Iteration& operator=(const Iteration&) = delete;

     private:
        World& world_;
    };

    [[nodiscard]] bool iterating() const { return iterations_.load(std::memory_order_relaxed) > 0; }
    template <class... C, class F, size_t... I>
    void walk(F& f, std::index_sequence<I...>);
    template <class... C, class F>
    static void walk_rows(F& f, const Entity* entities, size_t count, C*... columns);

    Entity take_slot();
    void place(Entity entity, uint32_t table);
    void destroy_one(Entity entity);
    /// The table that has the types of `table` and `id`, or those without `id` when it has it.
    uint32_t toggle(uint32_t table, ComponentId id);
    uint32_t table_with(uint32_t table, ComponentId id);
    uint32_t obtain_table(std::vector<ComponentId> ids);
    /// Moves what both tables have into the empty `row` of `target`; destroys the rest.
    void move(Entity entity, uint32_t target, uint32_t row);
    void apply();

    ComponentRegistry& registry_;
    std::vector<Slot, detail::ArrayAllocator<Slot>> slots_;
    uint32_t first_free_ = kFree;
    size_t size_ = 0;
    uint64_t version_ = 0;
    std::vector<std::unique_ptr<detail::Table>> tables_;  ///< the first is that of no components; gaps are null
    std::map<std::vector<ComponentId>, uint32_t> table_by_ids_;
    detail::Names names_;
    detail::Hierarchy hierarchy_;
    detail::CommandBuffer commands_;
    std::atomic<uint32_t> iterations_ = 0;  ///< atomic, for threads that read side by side
};

}  // namespace tyndall

#include "ecs/world.inl.h"
