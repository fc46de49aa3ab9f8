#include <fmt/format.h>

#include "geometry/readers.h"
#include "geometry/text_scanner.h"

namespace tyndall {

PolygonMesh read_off(std::string_view content, const std::string& source) {
    TextScanner text(content, source);
    std::string_view kind = text.next_word();
    const bool known = kind == "OFF" || kind == "COFF" || kind == "NOFF" || kind == "CNOFF";
    if (!known) text.fail(fmt::format("'{}' starts no OFF file that is read here", kind), "OFF, COFF, NOFF or CNOFF");
    const bool has_normals = kind.find('N') != std::string_view::npos;

    const auto count = [&](const char* what) {
        const long long value = text.whole(text.next_word());
        if (value < 0 || value > static_cast<long long>(content.size()))
            text.fail(fmt::format("the file promises {} {}", value, what));
        return value;
    };
    const long long vertices = count("vertices");
    const long long faces = count("faces");
    (void)count("edges");
    const auto vector = [&] {
        const auto number = [&] { return text.number(text.next_word()); };
        return glm::vec3{number(), number(), number()};
    };
    const auto end_line = [&] {
        while (!text.word().empty()) continue;
    };  // colours

    PolygonMesh mesh;
    for (long long i = 0; i < vertices; ++i) {
        mesh.positions.push_back(vector());
        if (has_normals) mesh.normals.push_back(vector());
        end_line();
    }
    for (long long i = 0; i < faces; ++i) {
        const long long size = text.whole(text.next_word());
        if (size < 3) text.fail(fmt::format("a face has {} corners", size), "3 or more");
        for (long long k = 0; k < size; ++k) {
            const long long index = text.whole(text.next_word());
            if (index < 0 || index >= vertices)
                text.fail(fmt::format("a face names vertex {}", index), fmt::format("0 to {}", vertices - 1));
            mesh.corners.push_back(static_cast<std::uint32_t>(index));
        }
        mesh.face_sizes.push_back(static_cast<std::uint32_t>(size));
        end_line();
    }
    if (has_normals) mesh.normal_corners = mesh.corners;
    return mesh;
}

}  // namespace tyndall
