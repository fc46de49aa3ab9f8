#include <gtest/gtest.h>

#include <string>

#include "compare_pictures.h"
#include "core/error.h"
#include "image/image_io.h"
#include "temporary_folder.h"

namespace tyndall {
namespace {

/// A picture of so many channels; each value tells its channel and place.
Image numbered(int channels) {
    Image image(6, 4, channels, Image::Type::f32);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 6; ++x)
            for (int c = 0; c < channels; ++c) image.at(x, y, c) = static_cast<float>(100 * c + 10 * y + x);
    return image;
}

class ImageLayers : public TemporaryFolder {
 protected:
    std::filesystem::path saved(const std::vector<std::string>& channels) const {
        save_exr(folder_ / "layers.exr", numbered(static_cast<int>(channels.size())), {false, channels, {}});
        return folder_ / "layers.exr";
    }
    std::string message_of(const std::filesystem::path& file, const char* layer) const {
        try {
            (void)load_layer(file, layer);
        } catch (const Error& error) {
            return error.what();
        }
        return {};
    }
};

/// The number of the channel that a loaded channel holds.
int channel_at(const Image& image, int channel) {
    return static_cast<int>(image.at(3, 2, channel) - 23) / 100;
}

TEST_F(ImageLayers, AreFoundByTheirNames) {
    const auto file =
        saved({"R", "G", "B", "variance.B", "variance.G", "variance.R", "normal.X", "normal.Y", "normal.Z", "samples"});
    const std::vector<std::string> layers = load_layer_names(file);
    EXPECT_EQ(layers.size(), 3u);
    const Image plain = load_layer(file, "");
    ASSERT_EQ(plain.channels, 3) << "the colours, without samples";
    for (int c = 0; c < 3; ++c) EXPECT_EQ(channel_at(plain, c), c);
    const Image variance = load_layer(file, "variance");
    ASSERT_EQ(variance.channels, 3);
    for (int c = 0; c < 3; ++c) EXPECT_EQ(channel_at(variance, c), 5 - c) << "red first";
    EXPECT_EQ(channel_at(load_layer(file, "normal"), 2), 8);
    const Image samples = load_layer(file, "samples");
    ASSERT_EQ(samples.channels, 1);
    EXPECT_EQ(channel_at(samples, 0), 9);
}

TEST_F(ImageLayers, OneLayerAloneNeedsNoName) {
    EXPECT_EQ(load_layer(saved({"beauty.R", "beauty.G", "beauty.B"}), "").channels, 3);
}

TEST_F(ImageLayers, UnknownOnesNameTheNearest) {
    const auto file = saved({"R", "G", "B", "variance.R", "variance.G", "variance.B"});
    const std::string message = message_of(file, "varience");
    EXPECT_NE(message.find("layers.exr"), std::string::npos) << message;
    EXPECT_NE(message.find("'varience'"), std::string::npos) << message;
    EXPECT_NE(message.find("did you mean 'variance'"), std::string::npos) << message;
    EXPECT_FALSE(message_of(saved({"a.R", "a.G", "b.R", "b.G"}), "").empty());
}

TEST_F(ImageLayers, OfOtherKindsOfFiles) {
    Image image(4, 2, 3, Image::Type::u8);
    image.bytes()[0] = 255;
    save_png(folder_ / "picture.png", image);
    const Image loaded = load_layer(folder_ / "picture.png", "");
    EXPECT_EQ(loaded.type, Image::Type::f32);
    EXPECT_EQ(loaded.at(0, 0, 0), 1.0f);
    EXPECT_THROW((void)load_layer(folder_ / "none.exr", ""), Error);
}

TEST(Image, Cropped) {
    const Image part = cropped(numbered(3), 2, 1, 3, 2);
    EXPECT_EQ(part.width, 3);
    EXPECT_EQ(part.height, 2);
    EXPECT_EQ(part.at(0, 0, 0), 12);
    EXPECT_EQ(part.at(2, 1, 2), 224);
    for (const auto& [x, y, w, h] :
         {std::array{0, 0, 7, 1}, {-1, 0, 2, 2}, {0, 0, 0, 1}, {5, 3, 1, 2}, {2147483647, 0, 1, 1}})
        EXPECT_THROW((void)cropped(numbered(3), x, y, w, h), Error);
}

}  // namespace
}  // namespace tyndall
