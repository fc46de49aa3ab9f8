#pragma once
// Numbers out of glTF accessors; included by the glTF sources alone.

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "scene/gltf_file.h"

namespace tyndall {

/// The elements of an accessor as float vectors: integers as they are, or as -1..1 or 0..1 when normalised; sparse
/// values put in place. Every byte is checked to lie in its buffer. Throws Error, also when the accessor has other than
/// T's components or more than `most` elements.
template <class T>
[[nodiscard]] std::vector<T> read_vectors(const GltfFile& file, int accessor, size_t most, std::string_view pointer);

extern template std::vector<glm::vec2> read_vectors(const GltfFile&, int, size_t, std::string_view);
extern template std::vector<glm::vec3> read_vectors(const GltfFile&, int, size_t, std::string_view);
extern template std::vector<glm::vec4> read_vectors(const GltfFile&, int, size_t, std::string_view);

/// The elements of an accessor of unsigned integers. Throws Error likewise.
[[nodiscard]] std::vector<uint32_t> read_indices(const GltfFile& file, int accessor, size_t most,
                                                 std::string_view pointer);

}  // namespace tyndall
