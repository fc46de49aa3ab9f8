#include "scene/gltf_values.h"

#include <algorithm>
#include <cmath>

namespace tyndall {

float GltfValues::in_range(const char* name, double value, double low, double high) {
    const double most = std::min(high, static_cast<double>(std::numeric_limits<float>::max()));
    const double least = std::max(low, static_cast<double>(std::numeric_limits<float>::lowest()));
    const double inside = std::isnan(value) ? least : std::clamp(value, least, most);
    if (inside != value) file_.warn(pointer_ + "/" + name + " is out of range: " + std::to_string(inside) + " is used");
    return static_cast<float>(inside);
}

glm::vec3 GltfValues::vector(const char* name, const std::vector<double>& values, const glm::vec3& fallback, double low,
                             double high) {
    if (values.size() != 3) return fallback;
    return {in_range(name, values[0], low, high), in_range(name, values[1], low, high),
            in_range(name, values[2], low, high)};
}

float GltfValues::number(const tinygltf::Value& object, const char* name, double fallback, double low, double high) {
    return in_range(name, number_or(member(object, name), fallback), low, high);
}

glm::vec3 GltfValues::vector(const tinygltf::Value& object, const char* name, const glm::vec3& fallback, double low,
                             double high) {
    return vector(name, numbers(member(object, name)), fallback, low, high);
}

const tinygltf::Value* member(const tinygltf::Value& object, const char* name) {
    return object.IsObject() && object.Has(name) ? &object.Get(name) : nullptr;
}

double number_or(const tinygltf::Value* value, double fallback) {
    return value && value->IsNumber() ? value->GetNumberAsDouble() : fallback;
}

std::vector<double> numbers(const tinygltf::Value* value) {
    std::vector<double> out;
    for (size_t i = 0; value && i < value->ArrayLen(); ++i) {
        const tinygltf::Value& item = value->Get(static_cast<int>(i));
        if (!item.IsNumber()) return {};
        out.push_back(item.GetNumberAsDouble());
    }
    return out;
}

const tinygltf::Value* extension(const tinygltf::ExtensionMap& extensions, const char* name) {
    const auto found = extensions.find(name);
    return found == extensions.end() || !found->second.IsObject() ? nullptr : &found->second;
}

}  // namespace tyndall
