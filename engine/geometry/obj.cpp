#include <fmt/format.h>

#include "geometry/readers.h"
#include "geometry/text_scanner.h"

namespace tyndall {
namespace {

/// One pass over the text of an OBJ file.
class ObjReader {
 public:
    ObjReader(std::string_view content, const std::string& source) : text_(content, source) {}

    PolygonMesh read() {
        while (text_.next_line()) {
            const std::string_view keyword = text_.word();
            if (keyword == "v")
                mesh_.positions.push_back(vector());
            else if (keyword == "vt")
                read_uv();
            else if (keyword == "vn")
                mesh_.normals.push_back(vector());
            else if (keyword == "f")
                read_face();
        }
        // Files where only some faces have an attribute: there is no honest value for the others.
        if (mesh_.uv_corners.size() != mesh_.corners.size()) mesh_.uv_corners.clear();
        if (mesh_.normal_corners.size() != mesh_.corners.size()) mesh_.normal_corners.clear();
        return std::move(mesh_);
    }

 private:
    float number() { return text_.number(text_.word()); }
    /// Braces, since they alone fix the order of evaluation.
    glm::vec3 vector() { return glm::vec3{number(), number(), number()}; }

    void read_uv() {
        const float u = number();
        mesh_.uvs.emplace_back(u, 1.0f - number());  // OBJ counts from the picture's bottom
    }

    /// 1 is the first, -1 the last so far.
    void add_index(std::string_view word, size_t count, const char* what, std::vector<std::uint32_t>& to) const {
        const long long index = text_.whole(word);
        const long long found = index < 0 ? static_cast<long long>(count) + index : index - 1;
        if (found < 0 || found >= static_cast<long long>(count))
            text_.fail(fmt::format("a face names {} {}", what, index), fmt::format("1 to {}", count));
        to.push_back(static_cast<std::uint32_t>(found));
    }

    /// Corners are "v", "v/vt", "v//vn" or "v/vt/vn".
    void read_face() {
        std::uint32_t size = 0;
        for (std::string_view corner = text_.word(); !corner.empty(); corner = text_.word(), ++size) {
            const size_t first = corner.find('/');
            const size_t second = first == std::string_view::npos ? first : corner.find('/', first + 1);
            add_index(corner.substr(0, first), mesh_.positions.size(), "vertex", mesh_.corners);
            if (first == std::string_view::npos) continue;
            const std::string_view uv = corner.substr(first + 1, second - first - 1);
            if (!uv.empty()) add_index(uv, mesh_.uvs.size(), "texture coordinate", mesh_.uv_corners);
            if (second == std::string_view::npos) continue;
            const std::string_view normal = corner.substr(second + 1);
            if (!normal.empty()) add_index(normal, mesh_.normals.size(), "normal", mesh_.normal_corners);
        }
        if (size < 3) text_.fail(fmt::format("a face has {} corners", size), "3 or more");
        mesh_.face_sizes.push_back(size);
    }

    TextScanner text_;
    PolygonMesh mesh_;
};

}  // namespace

PolygonMesh read_obj(std::string_view content, const std::string& source) {
    return ObjReader(content, source).read();
}

}  // namespace tyndall
