#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <memory>

#include "core/error.h"
#include "core/paths.h"
#include "image/image_io.h"

namespace tyndall {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, std::string message, std::string expected) {
    throw Error(Diagnostic{{file.string()}, std::move(message), std::move(expected), {}});
}

/// Encodes in memory, so that the file appears whole or not at all.
void save(const std::filesystem::path& file, const char* format, OIIO::ImageSpec spec, const Image& image) {
    std::vector<unsigned char> encoded;
    OIIO::Filesystem::IOVecOutput proxy(encoded);
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(format);
    const OIIO::TypeDesc type = image.type == Image::Type::u8    ? OIIO::TypeUInt8
                                : image.type == Image::Type::u16 ? OIIO::TypeUInt16
                                                                 : OIIO::TypeFloat;
    const bool done = output && output->set_ioproxy(&proxy) && output->open(std::string("memory.") + format, spec) &&
                      output->write_image(type, image.pixels.data()) && output->close();
    if (!done) fail(file, std::string("cannot encode: ") + (output ? output->geterror() : OIIO::geterror()), {});
    paths::write_file_atomically(file, {reinterpret_cast<const char*>(encoded.data()), encoded.size()});
}

OIIO::ImageSpec spec_of(const Image& image, OIIO::TypeDesc type) {
    OIIO::ImageSpec spec(image.width, image.height, image.channels, type);
    spec.attribute("oiio:UnassociatedAlpha", 1);  // our numbers go out as they are
    return spec;
}

std::vector<std::string> default_channel_names(int channels) {
    if (channels <= 2) return channels == 1 ? std::vector<std::string>{"Y"} : std::vector<std::string>{"Y", "A"};
    std::vector<std::string> names{"R", "G", "B"};
    if (channels > 3) names.emplace_back("A");
    for (int i = 4; i < channels; ++i) names.push_back("channel" + std::to_string(i));
    return names;
}

}  // namespace

void save_png(const std::filesystem::path& file, const Image& image) {
    if (image.empty() || image.type == Image::Type::f32 || image.channels > 4)
        fail(file, "this picture does not fit a PNG", "8- or 16-bit values, 1 to 4 channels");
    save(file, "png", spec_of(image, image.type == Image::Type::u8 ? OIIO::TypeUInt8 : OIIO::TypeUInt16), image);
}

void save_exr(const std::filesystem::path& file, const Image& image, const ExrOptions& options) {
    if (image.empty() || image.type != Image::Type::f32)
        fail(file, "this picture does not fit an EXR as saved here", "f32 values");
    OIIO::ImageSpec spec = spec_of(image, options.half ? OIIO::TypeHalf : OIIO::TypeFloat);
    spec.attribute("compression", "zip");
    // Left alone, OpenImageIO writes today's date: the same picture must give the same bytes.
    spec.attribute("DateTime", "2000:01:01 00:00:00");
    for (const auto& [key, value] : options.metadata) spec.attribute(key, value);
    spec.channelnames = options.channel_names.empty() ? default_channel_names(image.channels) : options.channel_names;
    if (spec.channelnames.size() != static_cast<size_t>(image.channels))
        fail(file, std::to_string(spec.channelnames.size()) + " channel names",
             std::to_string(image.channels) + ", one for each channel");
    for (int i = 0; i < image.channels; ++i)
        if (spec.channelnames[static_cast<size_t>(i)] == "A") spec.alpha_channel = i;
    if (options.half && !options.full_channels.empty())
        for (const std::string& name : spec.channelnames)
            spec.channelformats.push_back(std::ranges::find(options.full_channels, name) == options.full_channels.end()
                                              ? OIIO::TypeHalf
                                              : OIIO::TypeFloat);
    save(file, "openexr", spec, image);
}

}  // namespace tyndall
