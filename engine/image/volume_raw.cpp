#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/paths.h"
#include "image/volume_readers.h"

namespace tyndall {
namespace {

using Json = nlohmann::json;

const std::vector<std::string> kTypes = {"u8", "u16", "f32"};
const std::vector<std::string> kKeys = {"raw", "size", "type", "voxel_m", "byte_order", "about", "source", "licence"};

/// The description of a raw file, and complaints about it.
struct Description {
    const std::filesystem::path& file;
    Json json;

    Description(const std::filesystem::path& from, std::string_view text)
        : file(from), json(Json::parse(text, nullptr, false)) {
        if (!json.is_object()) fail("", "this is not JSON", "an object that describes a raw volume");
        for (const auto& [key, value] : json.items())
            if (std::ranges::find(kKeys, key) == kKeys.end())
                throw Error(Diagnostic{{file.string(), 0, 0, "/" + key},
                                       "unknown key '" + key + "'",
                                       "one of: raw, size, type, voxel_m, byte_order, about, source, licence",
                                       nearest_name(key, kKeys)});
    }

    [[noreturn]] void fail(const std::string& key, std::string message, std::string expected = {}) const {
        throw Error(Diagnostic{
            {file.string(), 0, 0, key.empty() ? "" : "/" + key}, std::move(message), std::move(expected), {}});
    }

    [[nodiscard]] std::string text(const std::string& key, const std::string& fallback) const {
        const auto found = json.find(key);
        if (found == json.end()) return fallback;
        if (!found->is_string()) fail(key, "a value of the wrong kind", "a text");
        return found->get<std::string>();
    }

    /// Three numbers between `low` and `high`; `fallback` when the key is absent.
    [[nodiscard]] glm::dvec3 triple(const std::string& key, double low, double high, const glm::dvec3* fallback) const {
        const std::string expected = fmt::format("three numbers from {} to {}", low, high);
        const auto found = json.find(key);
        if (found == json.end() && fallback) return *fallback;
        if (found == json.end()) fail("", "'" + key + "' is missing", expected);
        if (!found->is_array() || found->size() != 3) fail(key, "a value of the wrong kind", expected);
        glm::dvec3 values;
        for (int i = 0; i < 3; ++i) {
            const Json& value = (*found)[static_cast<size_t>(i)];
            if (!value.is_number()) fail(key, "a value of the wrong kind", expected);
            values[i] = value.get<double>();
            if (!(values[i] >= low && values[i] <= high)) fail(key, "a number out of range", expected);
        }
        return values;
    }
};

/// Values of `bytes` as T, swapped when the file has the other byte order, times `scale`.
template <class T>
std::vector<float> convert(const std::string& bytes, bool swap, float scale) {
    std::vector<float> values(bytes.size() / sizeof(T));
    for (size_t i = 0; i < values.size(); ++i) {
        std::array<char, sizeof(T)> raw;
        std::memcpy(raw.data(), bytes.data() + i * sizeof(T), sizeof(T));
        if (swap) std::ranges::reverse(raw);
        values[i] = scale * static_cast<float>(std::bit_cast<T>(raw));
    }
    return values;
}

}  // namespace

Volume load_raw_volume(const std::filesystem::path& file, std::string_view text,
                       std::vector<std::filesystem::path>& sources) {
    const Description description(file, text);
    const std::string type = description.text("type", "");
    if (std::ranges::find(kTypes, type) == kTypes.end())
        description.fail("type", "unknown type '" + type + "'", "u8, u16 or f32");
    const std::string order = description.text("byte_order", "little");
    if (order != "little" && order != "big")
        description.fail("byte_order", "unknown byte order '" + order + "'", "little or big");
    Volume volume{};
    const glm::dvec3 size = description.triple("size", 1.0, 65536.0, nullptr);
    if (size != glm::floor(size)) description.fail("size", "not whole numbers", "voxels along x, y and z");
    check_volume_size(file, int64_t(size.x), int64_t(size.y), int64_t(size.z));
    volume.size = glm::ivec3(size);
    const glm::dvec3 cubes(1.0);
    volume.voxel_m = glm::vec3(description.triple("voxel_m", 1e-9, 1e9, &cubes));

    const std::string name = description.text("raw", "");
    if (name.empty()) description.fail("", "'raw' is missing", "the name of the raw file");
    const std::filesystem::path raw = paths::resolve_asset(file.parent_path(), name);
    sources.push_back(raw);
    const size_t bytes_each = type == "u8" ? 1 : type == "u16" ? 2 : 4;
    const auto expected = static_cast<uintmax_t>(size.x * size.y * size.z) * bytes_each;
    const uintmax_t actual = std::filesystem::file_size(raw);
    if (actual != expected)
        throw Error(Diagnostic{{raw.string()},
                               fmt::format("the file has {} bytes", actual),
                               fmt::format("{}, as {} says", expected, file.filename().string()),
                               {}});
    const std::string bytes = paths::read_file(raw);
    if (bytes.size() != expected) throw Error(Diagnostic{{raw.string()}, "the file changed while it was read", {}, {}});
    const bool swap = (order == "big") != (std::endian::native == std::endian::big);
    volume.values = type == "u8"    ? convert<uint8_t>(bytes, swap, 1.0f / 255.0f)
                    : type == "u16" ? convert<uint16_t>(bytes, swap, 1.0f / 65535.0f)
                                    : convert<float>(bytes, swap, 1.0f);
    return volume;
}

}  // namespace tyndall
