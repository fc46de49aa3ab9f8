#pragma once
// A glTF file as tinygltf reads it, checked as far as everything that follows relies on; included by the glTF sources
// alone.

#include <tiny_gltf.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tyndall {

/// The parsed file with its buffers, and what is needed to complain about it.
struct GltfFile {
    std::filesystem::path path;
    tinygltf::Model model;  ///< images stay encoded: those of data URIs are bytes, others a buffer view or a URI
    std::vector<std::string> warnings;
    std::vector<std::filesystem::path>& sources;  ///< every file that was read

    /// Throws the Error about a place in the file, named by a JSON pointer.
    [[noreturn]] void fail(std::string pointer, std::string message, std::string expected = {}) const;
    /// Adds a warning, each text once.
    void warn(std::string warning);

    /// An element of one of the model's lists by an index from the file, or an Error: "there is no mesh 7 (expected
    /// 0 to 3)".
    template <class T>
    const T& at(const std::vector<T>& list, int index, std::string_view what, std::string_view pointer) const {
        if (index < 0 || static_cast<size_t>(index) >= list.size()) fail_index(index, list.size(), what, pointer);
        return list[static_cast<size_t>(index)];
    }
    /// The bytes of a buffer view, which lie inside their buffer.
    [[nodiscard]] std::span<const std::byte> bytes_of_view(int buffer_view, std::string_view pointer) const;
    /// The file beside this one that a URI means; it is added to the sources. Throws Error for what is no relative
    /// reference, leaves the folder or is not there.
    [[nodiscard]] std::filesystem::path resolve_uri(std::string_view uri, std::string_view pointer) const;

 private:
    [[noreturn]] void fail_index(int index, size_t size, std::string_view what, std::string_view pointer) const;
};

/// Reads a .gltf or .glb file and its buffers, and checks version and required extensions. Throws Error.
[[nodiscard]] GltfFile read_gltf(const std::filesystem::path& file, std::vector<std::filesystem::path>& sources);

}  // namespace tyndall
