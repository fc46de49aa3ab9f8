#include "scene/gltf_accessor.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>

namespace tyndall {
namespace {

/// Where elements lie: `count` of them, `stride` bytes apart, all inside the buffer. No data stands for zeros.
struct Elements {
    const std::byte* data = nullptr;
    size_t stride = 0;
    size_t count = 0;
    size_t components = 0;
    int type = 0;  ///< of a component: TINYGLTF_COMPONENT_TYPE_...
    bool normalised = false;
};

/// Throws unless the elements fit into a buffer view behind `offset`.
Elements inside_view(const GltfFile& file, Elements elements, int buffer_view, size_t offset,
                     std::string_view pointer) {
    const std::span<const std::byte> bytes = file.bytes_of_view(buffer_view, pointer);
    const auto size = static_cast<size_t>(tinygltf::GetComponentSizeInBytes(static_cast<uint32_t>(elements.type))) *
                      elements.components;
    if (elements.stride == 0) elements.stride = size;
    if (elements.stride < size) file.fail(std::string(pointer), "the stride is less than an element's size");
    if (offset > bytes.size() || size > bytes.size() - offset ||
        elements.count - 1 > (bytes.size() - offset - size) / elements.stride)
        file.fail(std::string(pointer), "the accessor reaches past its buffer view");
    elements.data = bytes.data() + offset;
    return elements;
}

Elements locate(const GltfFile& file, const tinygltf::Accessor& accessor, size_t most, const std::string& pointer) {
    const int components = tinygltf::GetNumComponentsInType(static_cast<uint32_t>(accessor.type));
    if (components < 1 || tinygltf::GetComponentSizeInBytes(static_cast<uint32_t>(accessor.componentType)) < 1)
        file.fail(pointer, "unknown type of elements");
    if (accessor.count < 1 || accessor.count > most)
        file.fail(pointer, std::to_string(accessor.count) + " elements", "1 to " + std::to_string(most));
    Elements elements{.count = accessor.count,
                      .components = static_cast<size_t>(components),
                      .type = accessor.componentType,
                      .normalised = accessor.normalized};
    if (accessor.bufferView < 0) return elements;
    elements.stride = file.at(file.model.bufferViews, accessor.bufferView, "buffer view", pointer).byteStride;
    return inside_view(file, elements, accessor.bufferView, accessor.byteOffset, pointer);
}

/// Calls `work` with a value of the type of the components.
template <class Work>
void with_component_type(int type, Work&& work) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return work(int8_t{});
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return work(uint8_t{});
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return work(int16_t{});
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return work(uint16_t{});
        case TINYGLTF_COMPONENT_TYPE_INT:
            return work(int32_t{});
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return work(uint32_t{});
        case TINYGLTF_COMPONENT_TYPE_DOUBLE:
            return work(double{});
        default:
            return work(float{});
    }
}

template <class Component>
float as_float(Component value, bool normalised) {
    if constexpr (std::is_integral_v<Component>) {
        if (normalised)
            return std::max(static_cast<float>(value) / static_cast<float>(std::numeric_limits<Component>::max()),
                            -1.0f);
    }
    return static_cast<float>(value);
}

/// Copies elements to out[target(i)].
template <class T, class Target>
void copy_vectors(const Elements& from, std::vector<T>& out, Target&& target) {
    with_component_type(from.type, [&](auto example) {
        using Component = decltype(example);
        for (size_t i = 0; i < from.count; ++i) {
            Component values[T::length()];
            std::memcpy(values, from.data + i * from.stride, sizeof values);
            T& element = out[target(i)];
            for (int c = 0; c < T::length(); ++c) element[c] = as_float(values[c], from.normalised);
        }
    });
}

std::vector<uint32_t> copy_indices(const Elements& from) {
    std::vector<uint32_t> out(from.count);
    with_component_type(from.type, [&](auto example) {
        using Component = decltype(example);
        for (size_t i = 0; i < from.count; ++i) {
            Component value{};
            std::memcpy(&value, from.data + i * from.stride, sizeof value);
            out[i] = static_cast<uint32_t>(value);
        }
    });
    return out;
}

bool is_index_type(int type) {
    return type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

/// Puts the values of a sparse accessor in their places (glTF 2.0, section 3.6.2.3).
template <class T>
void add_sparse(const GltfFile& file, const tinygltf::Accessor& accessor, const Elements& whole, std::vector<T>& out,
                const std::string& pointer) {
    const auto& sparse = accessor.sparse;
    if (sparse.count < 1 || static_cast<size_t>(sparse.count) > whole.count || sparse.indices.byteOffset < 0 ||
        sparse.values.byteOffset < 0 || !is_index_type(sparse.indices.componentType))
        file.fail(pointer + "/sparse", "count, offset or type of the indices is out of range");
    Elements places{.count = static_cast<size_t>(sparse.count), .components = 1, .type = sparse.indices.componentType};
    Elements values = whole;
    values.count = places.count;
    values.stride = 0;
    places = inside_view(file, places, sparse.indices.bufferView, static_cast<size_t>(sparse.indices.byteOffset),
                         pointer + "/sparse/indices");
    values = inside_view(file, values, sparse.values.bufferView, static_cast<size_t>(sparse.values.byteOffset),
                         pointer + "/sparse/values");
    const std::vector<uint32_t> at = copy_indices(places);
    if (std::ranges::max(at) >= out.size()) file.fail(pointer + "/sparse/indices", "an index is out of range");
    copy_vectors(values, out, [&](size_t i) { return at[i]; });
}

std::string pointer_of(int accessor) {
    return "/accessors/" + std::to_string(accessor);
}

}  // namespace

template <class T>
std::vector<T> read_vectors(const GltfFile& file, int index, size_t most, std::string_view pointer) {
    const tinygltf::Accessor& accessor = file.at(file.model.accessors, index, "accessor", pointer);
    const Elements elements = locate(file, accessor, most, pointer_of(index));
    if (elements.components != static_cast<size_t>(T::length()) || accessor.type == TINYGLTF_TYPE_MAT2)
        file.fail(pointer_of(index), "elements of " + std::to_string(elements.components) + " components",
                  std::to_string(T::length()) + ", as " + std::string(pointer) + " needs");
    std::vector<T> out(elements.count, T(0.0f));
    if (elements.data) copy_vectors(elements, out, [](size_t i) { return i; });
    if (accessor.sparse.isSparse) add_sparse(file, accessor, elements, out, pointer_of(index));
    return out;
}

template std::vector<glm::vec2> read_vectors(const GltfFile&, int, size_t, std::string_view);
template std::vector<glm::vec3> read_vectors(const GltfFile&, int, size_t, std::string_view);
template std::vector<glm::vec4> read_vectors(const GltfFile&, int, size_t, std::string_view);

std::vector<uint32_t> read_indices(const GltfFile& file, int index, size_t most, std::string_view pointer) {
    const tinygltf::Accessor& accessor = file.at(file.model.accessors, index, "accessor", pointer);
    const Elements elements = locate(file, accessor, most, pointer_of(index));
    if (elements.components != 1 || !is_index_type(elements.type) || accessor.sparse.isSparse || !elements.data)
        file.fail(pointer_of(index), "not an accessor of indices", "unsigned integers in a buffer view");
    return copy_indices(elements);
}

}  // namespace tyndall
