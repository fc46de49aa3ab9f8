#pragma once
// Numbers of glTF objects with their ranges; included by the glTF sources alone.

#include <glm/vec3.hpp>
#include <limits>
#include <string>
#include <vector>

#include "scene/gltf_file.h"

namespace tyndall {

/// Values of one object of the file. What is not in its range is moved there, with a warning; what is no number at all
/// counts as absent.
class GltfValues {
 public:
    GltfValues(GltfFile& file, std::string pointer) : file_(file), pointer_(std::move(pointer)) {}

    static constexpr double kInfinity = std::numeric_limits<double>::infinity();

    /// `value` as a finite float of the range.
    [[nodiscard]] float in_range(const char* name, double value, double low, double high);
    /// Three values of the range, or `fallback` when there are not three.
    [[nodiscard]] glm::vec3 vector(const char* name, const std::vector<double>& values, const glm::vec3& fallback,
                                   double low, double high);
    /// A number of an extension's object.
    [[nodiscard]] float number(const tinygltf::Value& object, const char* name, double fallback, double low,
                               double high);
    /// Three numbers of an extension's object.
    [[nodiscard]] glm::vec3 vector(const tinygltf::Value& object, const char* name, const glm::vec3& fallback,
                                   double low, double high);

    [[nodiscard]] const std::string& pointer() const { return pointer_; }

 private:
    GltfFile& file_;
    std::string pointer_;
};

/// A member of an extension's object, or null.
[[nodiscard]] const tinygltf::Value* member(const tinygltf::Value& object, const char* name);
/// A number, or the fallback when it is none.
[[nodiscard]] double number_or(const tinygltf::Value* value, double fallback);
/// The numbers of an array; empty when it is none or holds anything else.
[[nodiscard]] std::vector<double> numbers(const tinygltf::Value* value);
/// An extension's object, or null.
[[nodiscard]] const tinygltf::Value* extension(const tinygltf::ExtensionMap& extensions, const char* name);

}  // namespace tyndall
