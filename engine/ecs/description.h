#pragma once
/// Reflection: the one description of a component from which JSON reading and writing, validation, the JSON Schema, the
/// inspector, undo and hot reload all come.
///
/// A component is a plain struct with a static `kName` and a free `describe` beside it:
///
///     struct PointLight {
///         static constexpr std::string_view kName = "point_light";
///         float intensity_cd = 100.0f;
///     };
///     inline void describe(StructBuilder<PointLight>& d) {
///         d.doc("Light from a point into all directions.");
///         d.field("intensity_cd", &PointLight::intensity_cd, "Luminous intensity.").unit("cd").range(0, 1e9);
///     }
///
/// Nested structs and the alternatives of a std::variant are described the same way. Defaults are the values of a
/// default-constructed struct.

#include <cstddef>
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace tyndall {

/// What a field holds, as JSON sees it.
enum class FieldKind {
    boolean,
    integer,  ///< int32_t
    real,     ///< float
    vec2,
    vec3,  ///< array of three numbers
    vec4,
    quaternion,   ///< array x y z w, as glTF
    text,         ///< std::string
    enumeration,  ///< C++ enum; JSON string from `names`
    structure,    ///< nested struct; JSON object
    list,         ///< std::vector of structs, strings or numbers; JSON array
    choice,       ///< std::variant of structs; JSON object with exactly one key, from `names`
};

struct StructType;

/// One described member of a struct.
struct Field {
    std::string name;
    std::string doc;
    std::string unit;  ///< SI or photometric unit as text ("1/m", "cd", "deg"); empty = none
    FieldKind kind = FieldKind::real;
    size_t offset = 0;
    double minimum = -std::numeric_limits<double>::infinity();
    double maximum = std::numeric_limits<double>::infinity();
    bool colour = false;  ///< a vec3 that editors show as a colour, in the scene-linear space
    std::string asset;    ///< a text that names a file of this kind ("texture", "mesh", "gltf", "probe", "volume")
    std::vector<std::string> names;  ///< enumeration values in order; choice alternatives in order

    std::shared_ptr<const StructType> type;                       ///< structure: the nested type
    std::vector<std::shared_ptr<const StructType>> alternatives;  ///< choice: one per name
    std::shared_ptr<const Field> element;                         ///< list: describes one element (offset 0)

    // Access to what a byte offset alone cannot reach. Pointers address the field itself.
    int64_t (*get_enum)(const void* field) = nullptr;
    void (*set_enum)(void* field, int64_t value) = nullptr;
    size_t (*choice_index)(const void* field) = nullptr;
    void* (*choice_emplace)(void* field, size_t index) = nullptr;  ///< default-constructs alternative `index`
    void* (*choice_value)(void* field) = nullptr;
    size_t (*list_size)(const void* field) = nullptr;
    void (*list_resize)(void* field, size_t size) = nullptr;
    void* (*list_at)(void* field, size_t index) = nullptr;

    [[nodiscard]] void* in(void* object) const { return static_cast<std::byte*>(object) + offset; }
    [[nodiscard]] const void* in(const void* object) const { return static_cast<const std::byte*>(object) + offset; }
};

/// A described struct: its members and how the engine constructs, moves, copies and destroys it without knowing it.
struct StructType {
    std::string name;
    std::string doc;
    size_t size = 0;
    size_t alignment = 1;
    bool trivial = false;  ///< trivially copyable: storage may memcpy
    std::vector<Field> fields;

    void (*construct)(void* at) = nullptr;
    void (*copy_construct)(void* at, const void* from) = nullptr;
    void (*move_construct)(void* at, void* from) = nullptr;
    void (*destroy)(void* at) = nullptr;

    /// The field of that name, or null.
    [[nodiscard]] const Field* find(std::string_view field_name) const {
        for (const Field& field : fields)
            if (field.name == field_name) return &field;
        return nullptr;
    }
};

template <class T>
class StructBuilder;

/// The StructType of T, made by its `describe` (found by argument-dependent lookup).
template <class T>
std::shared_ptr<const StructType> describe_struct(std::string name);

/// Refines the field that StructBuilder::field just added.
class FieldBuilder {
 public:
    explicit FieldBuilder(Field& field) : field_(field) {}
    FieldBuilder& unit(std::string text) { return field_.unit = std::move(text), *this; }
    /// Inclusive; for vectors it holds per component.
    FieldBuilder& range(double low, double high) { return field_.minimum = low, field_.maximum = high, *this; }
    FieldBuilder& colour() { return field_.colour = true, *this; }
    FieldBuilder& asset(std::string kind) { return field_.asset = std::move(kind), *this; }

 private:
    Field& field_;
};

namespace detail {
template <class T>
struct IsVector : std::false_type {};
template <class T>
struct IsVector<std::vector<T>> : std::true_type {};
template <class T>
struct IsVariant : std::false_type {};
template <class... T>
struct IsVariant<std::variant<T...>> : std::true_type {};

template <class M>
Field make_field(std::vector<std::string> names);

template <class V, size_t... I>
void fill_choice(Field& field, std::index_sequence<I...>) {
    (field.alternatives.push_back(describe_struct<std::variant_alternative_t<I, V>>(field.names.at(I))), ...);
    field.choice_index = [](const void* p) { return static_cast<const V*>(p)->index(); };
    field.choice_value = [](void* p) { return std::visit([](auto& v) -> void* { return &v; }, *static_cast<V*>(p)); };
    field.choice_emplace = [](void* p, size_t index) -> void* {
        void* made = nullptr;
        ((index == I ? (made = &static_cast<V*>(p)->template emplace<I>()) : nullptr), ...);
        return made;
    };
}

template <class V>
void fill_list(Field& field) {
    using E = typename V::value_type;
    field.element = std::make_shared<const Field>(make_field<E>({}));
    field.list_size = [](const void* p) { return static_cast<const V*>(p)->size(); };
    field.list_resize = [](void* p, size_t n) { static_cast<V*>(p)->resize(n); };
    field.list_at = [](void* p, size_t i) -> void* { return &(*static_cast<V*>(p))[i]; };
}

template <class M>
Field make_field(std::vector<std::string> names) {
    Field field;
    field.names = std::move(names);
    if constexpr (std::is_same_v<M, bool>) {
        field.kind = FieldKind::boolean;
    } else if constexpr (std::is_same_v<M, int32_t>) {
        field.kind = FieldKind::integer;
    } else if constexpr (std::is_same_v<M, float>) {
        field.kind = FieldKind::real;
    } else if constexpr (std::is_same_v<M, glm::vec2>) {
        field.kind = FieldKind::vec2;
    } else if constexpr (std::is_same_v<M, glm::vec3>) {
        field.kind = FieldKind::vec3;
    } else if constexpr (std::is_same_v<M, glm::vec4>) {
        field.kind = FieldKind::vec4;
    } else if constexpr (std::is_same_v<M, glm::quat>) {
        field.kind = FieldKind::quaternion;
    } else if constexpr (std::is_same_v<M, std::string>) {
        field.kind = FieldKind::text;
    } else if constexpr (std::is_enum_v<M>) {
        field.kind = FieldKind::enumeration;
        field.get_enum = [](const void* p) { return static_cast<int64_t>(*static_cast<const M*>(p)); };
        field.set_enum = [](void* p, int64_t v) { *static_cast<M*>(p) = static_cast<M>(v); };
    } else if constexpr (IsVariant<M>::value) {
        field.kind = FieldKind::choice;
        fill_choice<M>(field, std::make_index_sequence<std::variant_size_v<M>>{});
    } else if constexpr (IsVector<M>::value) {
        field.kind = FieldKind::list;
        fill_list<M>(field);
    } else {
        field.kind = FieldKind::structure;
        field.type = describe_struct<M>({});
    }
    return field;
}
}  // namespace detail

/// Collects the description of T inside its `describe`.
template <class T>
class StructBuilder {
 public:
    explicit StructBuilder(StructType& type) : type_(type) {}

    /// One or two sentences: what it is, and its source.
    StructBuilder& doc(std::string text) { return type_.doc = std::move(text), *this; }

    /// Adds a member. `names` are the values of an enumeration or the alternatives of a choice, in declaration order.
    template <class M>
    FieldBuilder field(std::string name, M T::*member, std::string doc, std::vector<std::string> names = {}) {
        Field field = detail::make_field<M>(std::move(names));
        alignas(T) static const std::byte probe[sizeof(T)]{};
        const T* object = reinterpret_cast<const T*>(probe);
        field.offset = static_cast<size_t>(reinterpret_cast<const std::byte*>(&(object->*member)) - probe);
        field.name = std::move(name);
        field.doc = std::move(doc);
        type_.fields.push_back(std::move(field));
        return FieldBuilder(type_.fields.back());
    }

 private:
    StructType& type_;
};

template <class T>
std::shared_ptr<const StructType> describe_struct(std::string name) {
    auto type = std::make_shared<StructType>();
    type->name = std::move(name);
    type->size = sizeof(T);
    type->alignment = alignof(T);
    type->trivial = std::is_trivially_copyable_v<T>;
    type->construct = [](void* at) { new (at) T(); };
    type->copy_construct = [](void* at, const void* from) { new (at) T(*static_cast<const T*>(from)); };
    type->move_construct = [](void* at, void* from) { new (at) T(std::move(*static_cast<T*>(from))); };
    type->destroy = [](void* at) { static_cast<T*>(at)->~T(); };
    StructBuilder<T> builder(*type);
    describe(builder);
    return type;
}

}  // namespace tyndall
