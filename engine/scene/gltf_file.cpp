#include "scene/gltf_file.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <exception>
#include <utility>

#include "core/error.h"
#include "core/paths.h"
#include "scene/json_text.h"

namespace tyndall {
namespace fs = std::filesystem;
namespace {

/// More than tinygltf's own 32-bit lengths could take.
constexpr size_t kMaxFileBytes = size_t{1} << 30;

constexpr std::array kSupportedExtensions{"KHR_lights_punctual",
                                          "KHR_materials_emissive_strength",
                                          "KHR_materials_ior",
                                          "KHR_materials_specular",
                                          "KHR_materials_transmission",
                                          "KHR_materials_volume",
                                          "KHR_materials_diffuse_transmission",
                                          "KHR_mesh_quantization",
                                          "KHR_texture_transform"};

/// The two chunks of a .glb file (glTF 2.0, section 4.4). tinygltf checks less than this: it reads past a truncated
/// binary chunk.
struct Chunks {
    std::string_view json;
    std::string_view binary;
};

uint32_t word(std::string_view content, size_t at) {
    uint32_t value = 0;
    std::memcpy(&value, content.data() + at, sizeof value);
    return value;
}

Chunks split_glb(std::string_view content, const GltfFile& file) {
    constexpr uint32_t kJson = 0x4e4f534a;
    constexpr uint32_t kBinary = 0x004e4942;
    if (content.size() < 20) file.fail({}, "the file is truncated", "a glTF header of 20 bytes");
    if (word(content, 4) != 2) file.fail({}, "binary glTF of version " + std::to_string(word(content, 4)), "version 2");
    if (word(content, 8) != content.size())
        file.fail({}, "the file has " + std::to_string(content.size()) + " bytes, its header says " +
                          std::to_string(word(content, 8)));
    Chunks chunks;
    for (size_t at = 12; at + 8 <= content.size();) {
        const size_t length = word(content, at);
        const uint32_t kind = word(content, at + 4);
        if (length > content.size() - at - 8) file.fail({}, "a chunk reaches past the end of the file");
        if ((at == 12) != (kind == kJson)) file.fail({}, "the first chunk, and no other, must hold JSON");
        if (kind == kJson) chunks.json = content.substr(at + 8, length);
        if (kind == kBinary && chunks.binary.empty()) chunks.binary = content.substr(at + 8, length);
        at += 8 + length;
    }
    return chunks;
}

/// What tinygltf's callbacks know. It asks for external buffers in their order, and for images after them.
struct Loading {
    struct Buffer {
        std::string uri, pointer;
        size_t bytes = 0;
    };
    const GltfFile& file;
    std::vector<Buffer> external;
    size_t next = 0;
    std::exception_ptr error;
};

std::vector<Loading::Buffer> external_buffers(const JsonDocument& document, const GltfFile& file) {
    std::vector<Loading::Buffer> found;
    const JsonMember* buffers = document.root.find("buffers");
    if (!buffers) return found;
    for (size_t i = 0; i < buffers->value.items.size(); ++i) {
        const JsonMember* uri = buffers->value.items[i].find("uri");
        const JsonMember* bytes = buffers->value.items[i].find("byteLength");
        const std::string pointer = "/buffers/" + std::to_string(i);
        if (!uri || uri->value.string.empty() || tinygltf::IsDataURI(uri->value.string)) continue;
        if (!bytes || !(bytes->value.number >= 1.0 && bytes->value.number <= static_cast<double>(kMaxFileBytes)))
            file.fail(pointer, "'byteLength' is missing or out of range", "1 to 2^30");
        found.push_back({uri->value.string, pointer, static_cast<size_t>(bytes->value.number)});
    }
    return found;
}

bool buffer_exists(const std::string&, void* data) {
    const auto& loading = *static_cast<Loading*>(data);
    return loading.next < loading.external.size();
}

/// No exception may pass through a library that does not expect it: it is kept for after the call.
bool read_buffer(std::vector<unsigned char>* out, std::string*, const std::string&, void* data) {
    auto& loading = *static_cast<Loading*>(data);
    try {
        const Loading::Buffer& buffer = loading.external.at(loading.next++);
        const std::string content = paths::read_file(loading.file.resolve_uri(buffer.uri, buffer.pointer));
        if (content.size() < buffer.bytes)
            loading.file.fail(buffer.pointer, "'" + buffer.uri + "' has " + std::to_string(content.size()) + " bytes",
                              std::to_string(buffer.bytes) + " bytes, as 'byteLength' says");
        out->assign(content.begin(), content.begin() + static_cast<std::ptrdiff_t>(buffer.bytes));
        return true;
    } catch (...) {
        loading.error = std::current_exception();
        return false;
    }
}

/// Keeps the bytes of data URIs. A view into a buffer needs no copy, and tinygltf has not checked that it lies inside.
bool keep_image(tinygltf::Image* image, int, std::string*, std::string*, int, int, const unsigned char* bytes, int size,
                void*) {
    if (image->bufferView < 0) image->image.assign(bytes, bytes + size);
    return true;
}

/// tinygltf quotes whole data URIs.
std::string first_line(const std::string& text) {
    return text.substr(0, std::min<size_t>(text.find('\n'), 200));
}

void parse(GltfFile& file, const std::string& content, bool binary, std::vector<Loading::Buffer> external) {
    Loading loading{file, std::move(external), 0, nullptr};
    tinygltf::TinyGLTF reader;
    reader.SetImageLoader(keep_image, nullptr);
    reader.SetFsCallbacks(
        {buffer_exists, [](const std::string& name, void*) { return name; }, read_buffer,
         [](std::string*, const std::string&, const std::vector<unsigned char>&, void*) { return false; }, &loading});
    std::string errors;
    std::string ignored;
    bool ok = false;
    try {
        const auto size = static_cast<unsigned int>(content.size());
        ok = binary ? reader.LoadBinaryFromMemory(&file.model, &errors, &ignored,
                                                  reinterpret_cast<const unsigned char*>(content.data()), size)
                    : reader.LoadASCIIFromString(&file.model, &errors, &ignored, content.data(), size, "");
    } catch (const std::exception& error) {
        errors = error.what();
    }
    if (loading.error) std::rethrow_exception(loading.error);
    if (!ok) file.fail({}, "not a proper glTF file: " + (errors.empty() ? "no reason given" : first_line(errors)));
}

void check_extensions(GltfFile& file) {
    const auto supported = [](const std::string& name) {
        return std::ranges::find(kSupportedExtensions, name) != kSupportedExtensions.end();
    };
    std::string missing;
    for (const std::string& name : file.model.extensionsRequired)
        if (!supported(name)) missing += (missing.empty() ? "" : ", ") + name;
    if (!missing.empty()) {
        std::string known;
        for (const char* name : kSupportedExtensions) known += (known.empty() ? "" : ", ") + std::string(name);
        file.fail("/extensionsRequired",
                  "the file cannot be shown without extensions that are not supported: " + missing, "any of " + known);
    }
    for (const std::string& name : file.model.extensionsUsed)
        if (!supported(name)) file.warn("extension " + name + " is ignored");
}

}  // namespace

void GltfFile::fail(std::string pointer, std::string message, std::string expected) const {
    throw Error(Diagnostic{{path.string(), 0, 0, std::move(pointer)}, std::move(message), std::move(expected), {}});
}

void GltfFile::warn(std::string warning) {
    if (std::ranges::find(warnings, warning) == warnings.end()) warnings.push_back(std::move(warning));
}

void GltfFile::fail_index(int index, size_t size, std::string_view what, std::string_view pointer) const {
    fail(std::string(pointer), "there is no " + std::string(what) + " " + std::to_string(index),
         size == 0 ? "none: the file has no such list" : "0 to " + std::to_string(size - 1));
}

std::span<const std::byte> GltfFile::bytes_of_view(int buffer_view, std::string_view pointer) const {
    const tinygltf::BufferView& view = at(model.bufferViews, buffer_view, "buffer view", pointer);
    const std::string here = "/bufferViews/" + std::to_string(buffer_view);
    const tinygltf::Buffer& buffer = at(model.buffers, view.buffer, "buffer", here);
    if (view.byteOffset > buffer.data.size() || view.byteLength > buffer.data.size() - view.byteOffset)
        fail(here, "the view reaches past its buffer of " + std::to_string(buffer.data.size()) + " bytes");
    return std::as_bytes(std::span(buffer.data)).subspan(view.byteOffset, view.byteLength);
}

namespace {

int hex(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

/// Percent-encoding undone (RFC 3986); what is no proper code stays as it is.
std::string decode_uri(std::string_view uri) {
    std::string text;
    for (size_t i = 0; i < uri.size(); ++i) {
        const bool code = uri[i] == '%' && i + 2 < uri.size() && hex(uri[i + 1]) >= 0 && hex(uri[i + 2]) >= 0;
        text += code ? static_cast<char>(hex(uri[i + 1]) * 16 + hex(uri[i + 2])) : uri[i];
        if (code) i += 2;
    }
    return text;
}

}  // namespace

fs::path GltfFile::resolve_uri(std::string_view uri, std::string_view pointer) const {
    const std::string_view scheme = uri.substr(0, uri.find_first_of(":/"));
    if (scheme.size() < uri.size() && uri[scheme.size()] == ':')
        fail(std::string(pointer), "'" + std::string(uri.substr(0, 60)) + "' is not a file beside this one",
             "a relative path, or a data URI of a usual kind in base64");
    const std::string name = decode_uri(uri);
    sources.push_back((path.parent_path() / name).lexically_normal());
    try {
        return sources.emplace_back(paths::resolve_asset(path.parent_path(), name));
    } catch (Error& error) {
        throw Error(error).within(path.string() + ": " + std::string(pointer));
    }
}

GltfFile read_gltf(const fs::path& path, std::vector<fs::path>& sources) {
    GltfFile file{path, {}, {}, sources};
    const std::string content = paths::read_file(path);
    if (content.size() > kMaxFileBytes) file.fail({}, "the file is larger than 1 GiB");
    const bool binary = content.starts_with("glTF");
    // Our own reader tells where the JSON is broken, and bounds its nesting, through which tinygltf recurses.
    const std::string_view json = binary ? split_glb(content, file).json : std::string_view(content);
    const JsonDocument document = parse_json(std::string(json), path.string());
    parse(file, content, binary, external_buffers(document, file));
    if (!file.model.asset.version.starts_with("2."))
        file.fail("/asset/version", "glTF of version '" + file.model.asset.version + "'", "2.0");
    check_extensions(file);
    return file;
}

}  // namespace tyndall
