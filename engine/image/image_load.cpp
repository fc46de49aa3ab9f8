#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <memory>
#include <string>

#include "core/error.h"
#include "core/paths.h"
#include "image/image_reader.h"

namespace tyndall {
namespace {

using reading::fail;

/// Enough for the readers that decode in parallel, and little to take in vain.
constexpr int kRowsAtOnce = 256;

constexpr std::string_view kKnownFormats = "PNG, JPEG, OpenEXR, Radiance HDR, TIFF, Targa, BMP or WebP";

bool has_extension(std::string_view name, std::string_view extension) {
    return name.size() > extension.size() &&
           std::ranges::equal(name.substr(name.size() - extension.size()), extension,
                              [](unsigned char a, unsigned char b) { return std::tolower(a) == b; });
}

/// OpenImageIO's name of the format, told from the first bytes, so that only readers that we trust ever see a file.
std::string format_of(std::string_view head, std::string_view name) {
    using namespace std::string_view_literals;
    constexpr std::pair<std::string_view, const char*> kMagic[] = {
        {"\x89PNG"sv, "png"},     {"\xff\xd8\xff"sv, "jpeg"}, {"\x76\x2f\x31\x01"sv, "openexr"},
        {"#?RADIANCE"sv, "hdr"},  {"#?RGBE"sv, "hdr"},        {"II\x2a\x00"sv, "tiff"},
        {"MM\x00\x2a"sv, "tiff"}, {"II\x2b\x00"sv, "tiff"},   {"MM\x00\x2b"sv, "tiff"},
        {"BM"sv, "bmp"}};
    for (const auto& [magic, format] : kMagic)
        if (head.starts_with(magic)) return format;
    if (head.starts_with("RIFF") && head.substr(std::min<size_t>(8, head.size())).starts_with("WEBP")) return "webp";
    if (has_extension(name, ".tga") && head.size() >= 18) return "targa";  // Targa has no mark of its own
    fail(name, head.empty() ? "the file is empty" : "not a picture of a known kind", std::string(kKnownFormats));
}

/// libjpeg pads a truncated file with grey and calls it read; we ask for the end mark after the first scan.
void check_jpeg_end(std::string_view content, std::string_view name) {
    for (size_t at = 2; at + 4 <= content.size() && content[at] == '\xff';) {
        const auto byte = [&](size_t i) { return static_cast<size_t>(static_cast<unsigned char>(content[at + i])); };
        if (byte(1) == 0xda && content.find("\xff\xd9", at) != std::string_view::npos) return;
        at += byte(1) == 0xff ? 1 : 2 + byte(2) * 256 + byte(3);
    }
    fail(name, "the JPEG is truncated or corrupt: it has no end mark");
}

/// OpenImageIO leaks memory where libpng asks for bytes past the end: we follow the chunks to the last one first.
void check_png_end(std::string_view content, std::string_view name) {
    for (size_t at = 8; at + 12 <= content.size();) {
        size_t length = 0;
        for (size_t i = 0; i < 4; ++i) length = length << 8 | static_cast<unsigned char>(content[at + i]);
        if (length > content.size() - at - 12) break;
        if (content.substr(at + 4, 4) == "IEND") return;
        at += 12 + length;
    }
    fail(name, "the PNG is truncated or corrupt: it has no end mark");
}

/// Finds out early whether a picture is cut off, where its reader would not say so or would not cope.
void check_end(std::string_view content, std::string_view format, std::string_view name) {
    if (format == "jpeg") check_jpeg_end(content, name);
    if (format == "png") check_png_end(content, name);
}

Image::Type type_of(const OIIO::TypeDesc& format) {
    if (format == OIIO::TypeUInt8) return Image::Type::u8;
    if (format == OIIO::TypeUInt16) return Image::Type::u16;
    return Image::Type::f32;
}

OIIO::TypeDesc oiio_type(Image::Type type) {
    return type == Image::Type::u8 ? OIIO::TypeUInt8 : type == Image::Type::u16 ? OIIO::TypeUInt16 : OIIO::TypeFloat;
}

}  // namespace

namespace reading {

void fail(std::string_view name, std::string message, std::string expected, std::string suggestion) {
    throw Error(Diagnostic{{std::string(name)}, std::move(message), std::move(expected), std::move(suggestion)});
}

Reader::Reader(std::string_view content, std::string_view picture_name) : name(picture_name) {
    const std::string format = format_of(content, name);
    check_end(content, format, name);
    input = OIIO::ImageInput::create(format);
    if (!input) fail(name, "OpenImageIO was built without " + format + ": " + OIIO::geterror());
    if (!input->supports("ioproxy")) fail(name, format + " pictures can be read from files only");
    proxy = std::make_unique<OIIO::Filesystem::IOMemReader>(const_cast<char*>(content.data()), content.size());
    input->set_ioproxy(proxy.get());
    open("in memory." + format);
}

Reader::Reader(const std::filesystem::path& file, std::string_view format) : name(file.string()) {
    input = OIIO::ImageInput::create(std::string(format));
    if (!input) fail(name, "OpenImageIO was built without " + std::string(format) + ": " + OIIO::geterror());
    open(name);
}

Image Reader::read(int first_channel, int last_channel, bool as_float) {
    Image image;
    image.width = spec().width;
    image.height = spec().height;
    image.channels = last_channel - first_channel;
    image.type = as_float ? Image::Type::f32 : type_of(spec().format);
    check_image_size(image.width, image.height, image.channels, image.type);
    const size_t row = image.value_count() / static_cast<size_t>(image.height) * bytes_per_value(image.type);
    image.pixels.reserve(row * static_cast<size_t>(image.height));
    const int step = spec().tile_width > 0 ? image.height : kRowsAtOnce;
    for (int y = 0; y < image.height; y += step) {
        const int end = std::min(y + step, image.height);
        image.pixels.resize(row * static_cast<size_t>(end));
        std::byte* to = &image.pixels[row * static_cast<size_t>(y)];
        const OIIO::TypeDesc type = oiio_type(image.type);
        const bool read = spec().tile_width > 0 ? input->read_image(0, 0, first_channel, last_channel, type, to)
                                                : input->read_scanlines(0, 0, y + spec().y, end + spec().y, spec().z,
                                                                        first_channel, last_channel, type, to);
        if (!read || input->has_error()) fail(name, "the picture is truncated or corrupt: " + reason());
    }
    return image;
}

std::string Reader::reason() const {
    const std::string text = input->geterror();
    return text.empty() ? "no reason given" : text;
}

void Reader::open(const std::string& as) {
    OIIO::ImageSpec hints;
    hints.attribute("oiio:UnassociatedAlpha", 1);  // the file's own numbers, alpha not multiplied in
    OIIO::ImageSpec opened;
    if (!input->open(as, opened, hints)) fail(name, "cannot be read: " + reason());
    if (opened.deep) fail(name, "deep pictures are not read", "one value a channel");
    if (opened.depth > 1) fail(name, "volume pictures are not read", "one slice");
}

/// Opens a file by the kind that its first bytes tell.
Reader open_file(const std::filesystem::path& file, bool whole) {
    const std::string head = [&] {
        if (!std::filesystem::exists(file)) fail(file.string(), "no such file");
        if (!std::filesystem::is_regular_file(file)) fail(file.string(), "not a file");
        std::ifstream in(file, std::ios::binary);
        std::string bytes(64, '\0');
        in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        bytes.resize(static_cast<size_t>(in.gcount()));
        return bytes;
    }();
    const std::string format = format_of(head, file.string());
    if (whole && (format == "jpeg" || format == "png")) check_end(paths::read_file(file), format, file.string());
    return {file, format};
}

}  // namespace reading

using reading::guarded, reading::open_file, reading::Reader;

Image load_image(const std::filesystem::path& file) {
    return guarded(file.string(), [&] { return open_file(file, true).read(); });
}

Image load_image(std::span<const std::byte> content, std::string_view name) {
    const std::string_view text(reinterpret_cast<const char*>(content.data()), content.size());
    return guarded(name, [&] { return Reader(text, name).read(); });
}

ImageSize load_image_size(const std::filesystem::path& file) {
    return guarded(file.string(), [&] {
        const Reader reader = open_file(file, false);
        return ImageSize{reader.spec().width, reader.spec().height, reader.spec().nchannels};
    });
}

std::string load_text_attribute(const std::filesystem::path& file, const std::string& name) {
    return guarded(file.string(), [&] {
        const Reader reader = open_file(file, false);
        return std::string(reader.spec().get_string_attribute(name));
    });
}

}  // namespace tyndall
