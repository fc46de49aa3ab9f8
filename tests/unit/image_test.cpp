#include "image/image.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <random>

#include "core/error.h"
#include "core/paths.h"
#include "image/image_io.h"
#include "temporary_folder.h"

namespace tyndall {
namespace fs = std::filesystem;
namespace {

/// Smooth ramps with a little noise, all values in 0..1.
Image picture(int width, int height, int channels, Image::Type type) {
    Image image(width, height, channels, type);
    std::mt19937 random(7);
    for (size_t i = 0; i < image.value_count(); ++i) {
        const std::uint32_t v = (static_cast<std::uint32_t>(i * 97) + random() % 4000) % 65536;
        if (type == Image::Type::u8) image.bytes()[i] = static_cast<std::uint8_t>(v >> 8);
        if (type == Image::Type::u16) image.shorts()[i] = static_cast<std::uint16_t>(v);
        if (type == Image::Type::f32) image.floats()[i] = static_cast<float>(v) / 65536;
    }
    return image;
}

/// Written by OpenImageIO itself: the kinds of file that the engine only reads.
void write_foreign(const fs::path& file, const Image& image, OIIO::TypeDesc type) {
    const auto output = OIIO::ImageOutput::create(file.string());
    ASSERT_TRUE(output) << OIIO::geterror();
    ASSERT_TRUE(output->open(file.string(), OIIO::ImageSpec(image.width, image.height, image.channels, type)));
    const OIIO::TypeDesc in = image.type == Image::Type::u8 ? OIIO::TypeUInt8 : OIIO::TypeFloat;
    ASSERT_TRUE(output->write_image(in, image.pixels.data()) && output->close()) << output->geterror();
}

/// Without the sync of the engine's own writing, which would take most of the test's time.
void write(const fs::path& file, std::string_view content) {
    std::ofstream(file, std::ios::binary) << content;
}

std::string message_of(const fs::path& file) {
    try {
        (void)load_image(file);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

class ImageFiles : public TemporaryFolder {};

TEST_F(ImageFiles, PngKeepsEveryBit) {
    for (const auto type : {Image::Type::u8, Image::Type::u16})
        for (int channels = 1; channels <= 4; ++channels) {
            const Image image = picture(37, 21, channels, type);
            save_png(folder_ / "a.png", image);
            const Image back = load_image(folder_ / "a.png");
            ASSERT_EQ(back.type, type);
            ASSERT_EQ(back.channels, channels);
            EXPECT_EQ(back.pixels, image.pixels) << channels << " channels: alpha must not be multiplied in";
        }
}

TEST_F(ImageFiles, ExrKeepsEveryBitOfFloats) {
    Image image = picture(33, 20, 4, Image::Type::f32);
    image.at(0, 0, 0) = 1e30f;
    image.at(1, 0, 1) = -3.5f;
    save_exr(folder_ / "a.exr", image);
    EXPECT_EQ(load_image(folder_ / "a.exr").pixels, image.pixels);
    save_exr(folder_ / "half.exr", picture(8, 8, 3, Image::Type::f32), {.half = true});
    const Image half = load_image(folder_ / "half.exr");
    EXPECT_EQ(half.type, Image::Type::f32);
    EXPECT_NEAR(half.at(3, 3, 1), picture(8, 8, 3, Image::Type::f32).at(3, 3, 1), 1e-3f);
}

TEST_F(ImageFiles, SavingIsRepeatable) {
    const ExrOptions options{.channel_names = {"depth", "normal.x"}, .metadata = {{"scene", "chapel"}}};
    const Image image = picture(16, 9, 2, Image::Type::f32);
    save_exr(folder_ / "a.exr", image, options);
    save_exr(folder_ / "b.exr", image, options);
    EXPECT_EQ(paths::read_file(folder_ / "a.exr"), paths::read_file(folder_ / "b.exr"));
    const auto input = OIIO::ImageInput::open((folder_ / "a.exr").string());
    ASSERT_TRUE(input);
    EXPECT_EQ(input->spec().channelnames, options.channel_names);
    EXPECT_EQ(input->spec().get_string_attribute("scene"), "chapel");
    EXPECT_EQ(input->spec().get_string_attribute("DateTime"), "2000:01:01 00:00:00");
    for (const char* private_data : {"HostComputer", "Artist", "oiio:host"})
        EXPECT_FALSE(input->spec().find_attribute(private_data)) << private_data;
    save_png(folder_ / "a.png", to_u8(picture(9, 9, 3, Image::Type::f32)));
    save_png(folder_ / "b.png", to_u8(picture(9, 9, 3, Image::Type::f32)));
    EXPECT_EQ(paths::read_file(folder_ / "a.png"), paths::read_file(folder_ / "b.png"));
    EXPECT_EQ(paths::read_file(folder_ / "a.png").find("tIME"), std::string::npos);
}

TEST_F(ImageFiles, ReadsWhatItPromises) {
    const Image bytes = picture(40, 24, 3, Image::Type::u8);
    const Image floats = picture(40, 24, 3, Image::Type::f32);
    for (const char* name : {"a.jpg", "a.tif", "a.tga", "a.bmp", "a.webp", "a.png"}) {
        write_foreign(folder_ / name, bytes, OIIO::TypeUInt8);
        const Image back = load_image(folder_ / name);
        EXPECT_EQ(back.width, 40) << name;
        EXPECT_EQ(back.channels, 3) << name;
        EXPECT_EQ(load_image_size(folder_ / name).height, 24) << name;
    }
    for (const char* name : {"a.hdr", "a.exr", "f.tif"}) {
        write_foreign(folder_ / name, floats, OIIO::TypeFloat);
        const Image back = load_image(folder_ / name);
        ASSERT_EQ(back.type, Image::Type::f32) << name;
        EXPECT_NEAR(back.at(7, 5, 2), floats.at(7, 5, 2), 0.01f) << name;
    }
}

TEST_F(ImageFiles, ReadsFromMemory) {
    for (const char* name : {"a.png", "a.jpg", "a.webp", "a.exr"}) {
        const bool exr = std::string_view(name) == "a.exr";
        write_foreign(folder_ / name, picture(20, 10, 3, exr ? Image::Type::f32 : Image::Type::u8),
                      exr ? OIIO::TypeFloat : OIIO::TypeUInt8);
        const std::string content = paths::read_file(folder_ / name);
        const Image image = load_image(std::as_bytes(std::span(content)), "image 3 of a.glb");
        EXPECT_EQ(image.pixels, load_image(folder_ / name).pixels) << name;
        try {
            (void)load_image(std::as_bytes(std::span(content).first(content.size() / 2)), "image 3 of a.glb");
            ADD_FAILURE() << name << " was truncated";
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find("image 3 of a.glb"), std::string::npos) << error.what();
        }
    }
}

TEST_F(ImageFiles, ErrorsNameTheFile) {
    EXPECT_NE(message_of(folder_ / "none.png").find("none.png: no such file"), std::string::npos);
    paths::write_file_atomically(folder_ / "empty.png", "");
    EXPECT_NE(message_of(folder_ / "empty.png").find("empty.png: the file is empty"), std::string::npos);
    paths::write_file_atomically(folder_ / "text.png", "I am a poem, not a picture");
    EXPECT_NE(message_of(folder_ / "text.png").find("PNG, JPEG"), std::string::npos);
    EXPECT_NE(message_of(folder_).find("not a file"), std::string::npos);
    EXPECT_THROW(save_png(folder_ / "f.png", picture(4, 4, 3, Image::Type::f32)), Error);
    EXPECT_THROW(save_exr(folder_ / "b.exr", picture(4, 4, 3, Image::Type::u8)), Error);
    EXPECT_THROW(save_png(folder_ / "no" / "f.png", picture(4, 4, 3, Image::Type::u8)), Error);
}

TEST_F(ImageFiles, HugePicturesAreRefusedFromTheirHeader) {
    // A BMP header that promises 60000 x 60000 pixels.
    std::string header("BM\x36\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\x60\xea\0\0\x60\xea\0\0\x01\0\x18\0", 30);
    header.resize(200, '\0');
    paths::write_file_atomically(folder_ / "huge.bmp", header);
    EXPECT_FALSE(message_of(folder_ / "huge.bmp").empty());
    EXPECT_THROW(Image(kMaxImageSize + 1, 1, 1, Image::Type::u8), Error);
    EXPECT_THROW(Image(kMaxImageSize, kMaxImageSize, 4, Image::Type::f32), Error);
    EXPECT_THROW(Image(0, 1, 1, Image::Type::u8), Error);
}

/// Every kind of file, cut at many places, is refused; with bytes changed it loads or is refused, but never crashes.
TEST_F(ImageFiles, BrokenFilesAreErrors) {
    const Image bytes = picture(24, 16, 3, Image::Type::u8);
    const Image floats = picture(24, 16, 3, Image::Type::f32);
    std::mt19937 random(11);
    for (const char* name : {"a.jpg", "a.tif", "a.tga", "a.bmp", "a.webp", "a.png", "a.hdr", "a.exr"}) {
        const bool is_float = std::string_view(name) == "a.hdr" || std::string_view(name) == "a.exr";
        write_foreign(folder_ / name, is_float ? floats : bytes, is_float ? OIIO::TypeFloat : OIIO::TypeUInt8);
        const std::string whole = paths::read_file(folder_ / name);
        const auto pixels = load_image(folder_ / name).pixels;
        int whole_ones = 0;
        const fs::path broken = folder_ / (std::string("broken_") + name);
        for (size_t i = 1; i < 20; ++i) {
            write(broken, whole.substr(0, whole.size() * i / 21));
            try {  // what is cut off may be a thumbnail or a footer: then the picture is whole
                EXPECT_EQ(load_image(broken).pixels, pixels) << name << " cut at " << i << "/21";
                ++whole_ones;
            } catch (const Error& error) {
                EXPECT_NE(std::string(error.what()).find("broken_"), std::string::npos) << error.what();
            }
        }
        EXPECT_LE(whole_ones, std::string_view(name) == "a.tga" ? 6 : 1) << name;
        for (int i = 0; i < 60; ++i) {
            std::string mutated = whole;
            for (int k = 0; k < 3; ++k) mutated[random() % mutated.size()] = static_cast<char>(random());
            write(broken, mutated);
            (void)message_of(broken);
        }
    }
}

TEST(Image, Channels) {
    Image grey(2, 1, 1, Image::Type::u8);
    grey.bytes()[0] = 10;
    grey.bytes()[1] = 20;
    const Image four = with_channels(grey, 4);
    EXPECT_EQ(std::vector(four.bytes().begin(), four.bytes().end()),
              (std::vector<std::uint8_t>{10, 10, 10, 255, 20, 20, 20, 255}));
    const Image grey_alpha = with_channels(grey, 2);
    EXPECT_EQ(std::vector(grey_alpha.bytes().begin(), grey_alpha.bytes().end()),
              (std::vector<std::uint8_t>{10, 255, 20, 255}));
    Image pair = grey_alpha;
    pair.bytes()[1] = 99;
    EXPECT_EQ(with_channels(pair, 4).bytes()[2], 10);
    EXPECT_EQ(with_channels(pair, 4).bytes()[3], 99);
    Image colour(1, 1, 3, Image::Type::f32);
    colour.at(0, 0, 2) = 0.5f;
    EXPECT_EQ(with_channels(colour, 4).at(0, 0, 2), 0.5f);
    EXPECT_EQ(with_channels(colour, 4).at(0, 0, 3), 1.0f);
    EXPECT_EQ(with_channels(with_channels(colour, 4), 3).pixels, colour.pixels);
}

TEST(Image, ConversionsRound) {
    Image image(5, 1, 1, Image::Type::f32);
    const float values[] = {-1.0f, 0.5f, 2.0f, std::numeric_limits<float>::quiet_NaN(), 1.0f / 255};
    std::ranges::copy(values, image.floats().begin());
    const Image bytes = to_u8(image);
    EXPECT_EQ(std::vector(bytes.bytes().begin(), bytes.bytes().end()), (std::vector<std::uint8_t>{0, 128, 255, 0, 1}));
    const Image every = picture(64, 64, 1, Image::Type::u8);
    EXPECT_EQ(to_u8(to_float(every)).pixels, every.pixels);
    EXPECT_THROW((void)every.floats(), Error);
}

TEST(Image, ResizeAverages) {
    const Image image = picture(12, 8, 3, Image::Type::f32);
    const Image small = box_downsample(image, 4);
    ASSERT_EQ(small.width, 3);
    ASSERT_EQ(small.height, 2);
    double sum = 0;
    for (int y = 4; y < 8; ++y)
        for (int x = 8; x < 12; ++x) sum += static_cast<double>(image.at(x, y, 1));
    EXPECT_NEAR(small.at(2, 1, 1), sum / 16, 1e-6);
    EXPECT_THROW((void)box_downsample(image, 5), Error);

    const auto mean = [](const Image& i) {
        double total = 0;
        for (const float v : i.floats()) total += static_cast<double>(v);
        return total / static_cast<double>(i.value_count());
    };
    EXPECT_NEAR(mean(resize(image, 5, 3)), mean(image), 1e-6);  // uneven sizes keep the mean as well
    EXPECT_NEAR(mean(resize(image, 24, 16)), mean(image), 1e-6);
    EXPECT_EQ(resize(image, 24, 16).at(23, 15, 0), image.at(11, 7, 0));
    EXPECT_EQ(resize(image, 12, 8).pixels, image.pixels);
    EXPECT_EQ(flip_rows(flip_rows(image)).pixels, image.pixels);
    EXPECT_EQ(flip_rows(image).at(3, 0, 2), image.at(3, 7, 2));
}

}  // namespace
}  // namespace tyndall
