#include <cmath>

#include "scene/engine_extraction.h"

namespace tyndall {

glm::mat4 rigid_transform(const glm::mat4& transform) {
    const auto unit = [](const glm::vec3& v, const glm::vec3& fallback) {
        const float length = glm::length(v);
        return length > 1e-12f && std::isfinite(length) ? v / length : fallback;
    };
    // What looks along -Z keeps its direction exactly, and its up as near as can be.
    const glm::vec3 back = unit(glm::vec3(transform[2]), {0.0f, 0.0f, 1.0f});
    const glm::vec3 any = std::abs(back.y) < 0.9f ? glm::vec3(0.0f, 1.0f, 0.0f) : glm::vec3(1.0f, 0.0f, 0.0f);
    const glm::vec3 side = unit(glm::cross(any, back), {1.0f, 0.0f, 0.0f});
    const glm::vec3 right = unit(glm::cross(glm::vec3(transform[1]), back), side);
    return {glm::vec4(right, 0.0f), glm::vec4(glm::cross(back, right), 0.0f), glm::vec4(back, 0.0f),
            glm::vec4(glm::vec3(transform[3]), 1.0f)};
}

bool matches_glob(std::string_view pattern, std::string_view name) {
    // On a mismatch the last '*' takes one character more: linear for what people write, never exponential.
    size_t p = 0;
    size_t n = 0;
    size_t star = std::string_view::npos;
    size_t taken = 0;
    while (n < name.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            taken = n;
        } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == name[n])) {
            ++p;
            ++n;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            n = ++taken;
        } else {
            return false;
        }
    }
    return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

}  // namespace tyndall
