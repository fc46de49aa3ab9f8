#pragma once
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace tyndall {

/// Small glTF files for tests: one buffer that grows, and the JSON around it.
struct GltfWriter {
    nlohmann::json root{{"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", {{{"nodes", {0}}}}}};
    std::string buffer;

    /// Appends to a list of the root; gives the index.
    int add(const char* list, nlohmann::json item) {
        root[list].push_back(std::move(item));
        return static_cast<int>(root[list].size()) - 1;
    }
    int view(std::string_view bytes, int stride = 0) {
        buffer.resize((buffer.size() + 3) / 4 * 4);
        nlohmann::json view{{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", bytes.size()}};
        if (stride > 0) view["byteStride"] = stride;
        buffer += bytes;
        return add("bufferViews", view);
    }
    template <class T>
    int view_of(const std::vector<T>& values, int stride = 0) {
        return view({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)}, stride);
    }
    int accessor(int view, int component_type, const char* type, size_t count) {
        return add("accessors",
                   {{"bufferView", view}, {"componentType", component_type}, {"type", type}, {"count", count}});
    }
    int floats(const std::vector<float>& values, const char* type) {
        const size_t components = type[0] == 'S' ? 1 : static_cast<size_t>(type[3] - '0');
        return accessor(view_of(values), 5126, type, values.size() / components);
    }
    int indices(const std::vector<uint16_t>& values) {
        return accessor(view_of(values), 5123, "SCALAR", values.size());
    }
    /// A mesh of one primitive on a node of its own.
    nlohmann::json& primitive(nlohmann::json attributes) {
        const int mesh = add("meshes", {{"primitives", {{{"attributes", std::move(attributes)}}}}});
        add("nodes", {{"mesh", mesh}});
        return root["meshes"][static_cast<size_t>(mesh)]["primitives"][0];
    }
    /// The simplest mesh: positions of a triangle with a material.
    void triangle(nlohmann::json material = nlohmann::json::object()) {
        const int positions = floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
        primitive({{"POSITION", positions}})["material"] = add("materials", std::move(material));
    }

    [[nodiscard]] std::string glb() {
        root["buffers"] = {{{"byteLength", buffer.size()}}};
        std::string json = root.dump();
        json.resize((json.size() + 3) / 4 * 4, ' ');
        std::string binary = buffer;
        binary.resize((binary.size() + 3) / 4 * 4);
        std::string out = "glTF";
        for (const size_t word : {size_t{2}, 12 + 8 + json.size() + 8 + binary.size(), json.size(), size_t{0x4e4f534a}})
            out += word_bytes(word);
        out += json + word_bytes(binary.size()) + word_bytes(0x004e4942) + binary;
        return out;
    }
    /// As text, with the buffer in a data URI, or at `uri`.
    [[nodiscard]] std::string gltf(const std::string& uri = {}) {
        const std::string inside = "data:application/octet-stream;base64," + base64(buffer);
        root["buffers"] = {{{"byteLength", buffer.size()}, {"uri", uri.empty() ? inside : uri}}};
        return root.dump(1);
    }

    [[nodiscard]] static std::string base64(std::string_view bytes) {
        constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        std::string out;
        for (size_t i = 0; i < bytes.size(); i += 3) {
            uint32_t group = 0;
            for (size_t k = 0; k < 3; ++k)
                group = group << 8 | (i + k < bytes.size() ? static_cast<uint8_t>(bytes[i + k]) : 0u);
            for (size_t k = 0; k < 4; ++k) out += i + k > bytes.size() ? '=' : kDigits[group >> (18 - 6 * k) & 63u];
        }
        return out;
    }

 private:
    static std::string word_bytes(size_t value) {
        const auto word = static_cast<uint32_t>(value);
        std::string out(4, '\0');
        std::memcpy(out.data(), &word, 4);
        return out;
    }
};

}  // namespace tyndall
