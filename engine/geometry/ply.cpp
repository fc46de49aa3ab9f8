#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "core/error.h"
#include "geometry/readers.h"
#include "geometry/text_scanner.h"

namespace tyndall {
namespace {

enum class Type { i8, u8, i16, u16, i32, u32, f32, f64 };
enum class Encoding { text, little_endian, big_endian };

struct Property {
    std::string name;
    Type type = Type::f32;
    bool is_list = false;
    Type count_type = Type::u8;
};

struct Element {
    std::string name;
    long long count = 0;
    std::vector<Property> properties;
};

/// The values of a file's body, one after the other. Reading past the end is an Error, so that no promise of a header
/// can be larger than the file.
class Values {
 public:
    Values(std::string_view body, Encoding encoding, const std::string& source, int line)
        : encoding_(encoding), text_(body, source, line), bytes_(body), source_(source) {}

    double next(Type type) {
        if (encoding_ == Encoding::text) return static_cast<double>(text_.number(text_.next_word()));
        switch (type) {
            case Type::i8:
                return take<std::int8_t>();
            case Type::u8:
                return take<std::uint8_t>();
            case Type::i16:
                return take<std::int16_t>();
            case Type::u16:
                return take<std::uint16_t>();
            case Type::i32:
                return take<std::int32_t>();
            case Type::u32:
                return take<std::uint32_t>();
            case Type::f32:
                return static_cast<double>(take<float>());
            case Type::f64:
                return take<double>();
        }
        return 0;
    }
    [[noreturn]] void fail(std::string message) const {
        if (encoding_ == Encoding::text) text_.fail(std::move(message));
        throw Error(Diagnostic{{source_}, std::move(message), {}, {}});
    }

 private:
    template <class T>
    T take() {
        char raw[sizeof(T)];
        if (bytes_.size() < sizeof raw) fail("the file ends too early: it is truncated");
        std::memcpy(raw, bytes_.data(), sizeof raw);
        bytes_.remove_prefix(sizeof raw);
        const bool little = encoding_ == Encoding::little_endian;
        if (little != (std::endian::native == std::endian::little)) std::reverse(std::begin(raw), std::end(raw));
        T value;
        std::memcpy(&value, raw, sizeof raw);
        return value;
    }

    Encoding encoding_;
    TextScanner text_;
    std::string_view bytes_;
    const std::string& source_;
};

Type type_of(const TextScanner& text, std::string_view name) {
    constexpr std::pair<std::string_view, Type> kTypes[] = {
        {"char", Type::i8},   {"int8", Type::i8},     {"uchar", Type::u8},   {"uint8", Type::u8},
        {"short", Type::i16}, {"int16", Type::i16},   {"ushort", Type::u16}, {"uint16", Type::u16},
        {"int", Type::i32},   {"int32", Type::i32},   {"uint", Type::u32},   {"uint32", Type::u32},
        {"float", Type::f32}, {"float32", Type::f32}, {"double", Type::f64}, {"float64", Type::f64}};
    for (const auto& [known, type] : kTypes)
        if (name == known) return type;
    text.fail(fmt::format("unknown type '{}'", name), "char, uchar, short, ushort, int, uint, float or double");
}

Encoding encoding_of(const TextScanner& text, std::string_view name) {
    if (name == "ascii") return Encoding::text;
    if (name == "binary_little_endian") return Encoding::little_endian;
    if (name == "binary_big_endian") return Encoding::big_endian;
    text.fail(fmt::format("unknown format '{}'", name), "ascii, binary_little_endian or binary_big_endian");
}

struct Header {
    Encoding encoding = Encoding::text;
    std::vector<Element> elements;
};

/// Reads up to and with "end_header".
Header read_header(TextScanner& text) {
    Header header;
    if (!text.next_line() || text.word() != "ply") text.fail("not a PLY file", "'ply' in the first line");
    while (text.next_line()) {
        const std::string_view keyword = text.word();
        if (keyword == "end_header") return header;
        if (keyword == "format") header.encoding = encoding_of(text, text.word());
        if (keyword == "element") {
            const std::string_view name = text.word();
            header.elements.push_back({std::string(name), text.whole(text.word()), {}});
        }
        if (keyword != "property") continue;
        if (header.elements.empty()) text.fail("a property before any element");
        Property property;
        std::string_view type = text.word();
        if (type == "list") {
            property.is_list = true;
            property.count_type = type_of(text, text.word());
            type = text.word();
        }
        property.type = type_of(text, type);
        property.name = text.word();
        header.elements.back().properties.push_back(property);
    }
    text.fail("the header has no end: the file is truncated");
}

/// Which of the names that writers use for a vertex' values this is; -1: none of interest.
int vertex_slot(std::string_view name) {
    constexpr std::pair<std::string_view, int> kSlots[] = {
        {"x", 0}, {"y", 1}, {"z", 2}, {"nx", 3},        {"ny", 4},        {"nz", 5},    {"u", 6},
        {"v", 7}, {"s", 6}, {"t", 7}, {"texture_u", 6}, {"texture_v", 7}, {"radius", 8}};
    for (const auto& [known, slot] : kSlots)
        if (name == known) return slot;
    return -1;
}

void read_vertices(Values& values, const Element& element, PolygonMesh& mesh) {
    bool has[9] = {};
    for (const Property& property : element.properties)
        if (const int slot = vertex_slot(property.name); slot >= 0 && !property.is_list) has[slot] = true;
    if (!has[0] || !has[1] || !has[2]) values.fail("the vertices have no x, y and z");
    for (long long i = 0; i < element.count; ++i) {
        float v[9] = {};
        for (const Property& property : element.properties) {
            const double count = property.is_list ? values.next(property.count_type) : 1;
            for (double k = 0; k < count; ++k) {
                const double value = values.next(property.type);
                if (const int slot = vertex_slot(property.name); slot >= 0) v[slot] = static_cast<float>(value);
            }
        }
        mesh.positions.emplace_back(v[0], v[1], v[2]);
        if (has[3] && has[4] && has[5]) mesh.normals.emplace_back(v[3], v[4], v[5]);
        if (has[8]) mesh.radii.push_back(v[8]);
        if (has[6] && has[7]) mesh.uvs.emplace_back(v[6], 1.0f - v[7]);  // from the picture's bottom, as in OBJ
    }
}

void read_faces(Values& values, const Element& element, PolygonMesh& mesh) {
    for (long long i = 0; i < element.count; ++i)
        for (const Property& property : element.properties) {
            const bool corners = property.is_list && property.name.starts_with("vertex_ind");
            const double count = property.is_list ? values.next(property.count_type) : 1;
            if (corners && !(count >= 3)) values.fail(fmt::format("a face has {} corners", count));
            for (double k = 0; k < count; ++k) {
                const double index = values.next(property.type);
                if (!corners) continue;
                if (!(index >= 0 && index < static_cast<double>(mesh.positions.size())))
                    values.fail(fmt::format("a face names vertex {} of {}", index, mesh.positions.size()));
                mesh.corners.push_back(static_cast<std::uint32_t>(index));
            }
            if (corners) mesh.face_sizes.push_back(static_cast<std::uint32_t>(count));
        }
}

}  // namespace

PolygonMesh read_ply(std::string_view content, const std::string& source) {
    TextScanner text(content, source);
    const Header header = read_header(text);
    Values values(text.rest(), header.encoding, source, text.line_number() + 1);
    PolygonMesh mesh;
    for (const Element& element : header.elements) {
        if (element.properties.empty()) continue;
        if (element.name == "vertex")
            read_vertices(values, element, mesh);
        else
            read_faces(values, element, mesh);  // other elements have no corners and are passed over
    }
    if (!mesh.uvs.empty()) mesh.uv_corners = mesh.corners;
    if (!mesh.normals.empty()) mesh.normal_corners = mesh.corners;
    return mesh;
}

}  // namespace tyndall
