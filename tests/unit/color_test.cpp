#include "color/color.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <random>

#include "core/error.h"
#include "core/paths.h"
#include "temporary_folder.h"

namespace tyndall {
namespace fs = std::filesystem;
namespace {

const fs::path kOwn = "config/color/tyndall.ocio";  // tests run from the project's root
const fs::path kShared = "../shared/assets/ocio";

template <class Work>
std::string message_of(Work&& work) {
    try {
        work();
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

bool contains(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

float srgb_decoded(float v) {
    return v > 0.04045f ? std::pow((v + 0.055f) / 1.055f, 2.4f) : v / 12.92f;
}

TEST(OwnConfig, HasTheViewsThatItPromises) {
    const ColorConfig config(kOwn);
    EXPECT_EQ(config.default_display(), "sRGB");
    EXPECT_EQ(config.default_view(), "ACES 1.0 SDR");
    EXPECT_EQ(config.views(), (std::vector<std::string>{"ACES 1.0 SDR", "sRGB", "Rec.1886", "Raw"}));
    EXPECT_EQ(config.views("Rec.1886"), (std::vector<std::string>{"ACES 1.0 SDR", "Rec.1886", "Raw"}));
    EXPECT_EQ(config.working_space(), "Linear Rec.709");
}

TEST(OwnConfig, EveryViewHasAShaderWithoutTables) {
    const ColorConfig config(kOwn);
    for (const std::string& display : config.displays())
        for (const std::string& view : config.views(display)) {
            const DisplayShader shader = config.display_shader(display, view);
            EXPECT_TRUE(contains(shader.text, "vec4 ocio_display(vec4")) << display << " / " << view;
            EXPECT_TRUE(shader.luts.empty());
            EXPECT_TRUE(shader.uniforms.empty());
        }
}

TEST(OwnConfig, PlainViewsAreTheirCurves) {
    const ColorConfig config(kOwn);
    for (const float v : {0.0f, 0.001f, 0.18f, 0.5f, 1.0f}) {
        std::vector<float> srgb{v, v, v};
        config.apply_display(srgb, "sRGB", "sRGB");
        EXPECT_NEAR(srgb_decoded(srgb[0]), v, 2e-5f);
        EXPECT_NEAR(srgb[0], srgb[2], 1e-5f);  // neutral stays neutral
        std::vector<float> rec1886{v, v, v};
        config.apply_display(rec1886, "sRGB", "Rec.1886");
        EXPECT_NEAR(std::pow(rec1886[1], 2.4f), v, 2e-5f);
        std::vector<float> raw{v, 2 * v, -v};
        config.apply_display(raw, "sRGB", "Raw");
        EXPECT_EQ(raw, (std::vector<float>{v, 2 * v, -v}));
    }
}

TEST(OwnConfig, ConversionsRoundTrip) {
    const ColorConfig config(kOwn);
    std::mt19937 random(5);
    std::vector<float> colours(300);
    for (float& v : colours) v = static_cast<float>(random() % 1000) / 1000;
    for (const char* space : {"ACES2065-1", "ACEScg", "sRGB Texture", "srgb_tx"}) {
        std::vector<float> back = colours;
        config.convert(back, space, "scene_linear");
        EXPECT_NE(back, colours);
        config.convert(back, "scene_linear", space);
        for (size_t i = 0; i < colours.size(); ++i) ASSERT_NEAR(back[i], colours[i], 3e-5f) << space;
    }
}

TEST(OwnConfig, FileRules) {
    const ColorConfig config(kOwn);
    const std::map<std::string, std::string> expected{{"textures/stone.png", "sRGB Texture"},
                                                      {"textures/stone.jpg", "sRGB Texture"},
                                                      {"probes/noon.hdr", "Linear Rec.709"},
                                                      {"a.b/noon.EXR", "Linear Rec.709"},
                                                      {"textures/stone_normal.png", "Raw"},
                                                      {"textures/stone_Normal.PNG", "Raw"},
                                                      {"textures/stone_orm.png", "Raw"},
                                                      {"textures/stone_roughness_2k.jpg", "Raw"},
                                                      {"textures/stone_normal.exr", "Raw"},
                                                      {"textures/paranormal.png", "sRGB Texture"},
                                                      {"stone_normal/colour.png", "sRGB Texture"},
                                                      {"textures/wood-metallic.tif", "Raw"},
                                                      {"a file with blanks_ao.webp", "Raw"},
                                                      {"textures/humid.png", "sRGB Texture"},
                                                      {"textures/normal_painting.jpg", "sRGB Texture"}};
    for (const auto& [file, space] : expected) EXPECT_EQ(config.space_of_file(file), space) << file;
    EXPECT_EQ(config.space_of_file("stone_normal.png", "srgb_texture"), "sRGB Texture");
    EXPECT_TRUE(config.is_data(config.space_of_file("stone.png", "data")));
    EXPECT_TRUE(config.is_data("Raw"));
    EXPECT_FALSE(config.is_data("scene_linear"));
    EXPECT_TRUE(config.decodes_as_srgb(config.srgb_texture_space()));
    EXPECT_FALSE(config.decodes_as_srgb("ACEScg"));
    EXPECT_FALSE(config.decodes_as_srgb("scene_linear"));
}

TEST(OwnConfig, PicturesBecomeWorkingFloats) {
    const ColorConfig config(kOwn);
    Image image(2, 1, 4, Image::Type::u8);
    for (size_t i = 0; i < 8; ++i) image.bytes()[i] = static_cast<std::uint8_t>(30 * i);
    const Image working = config.to_working(image, "sRGB Texture");
    ASSERT_EQ(working.type, Image::Type::f32);
    for (size_t i = 0; i < 8; ++i) {
        const float v = static_cast<float>(image.bytes()[i]) / 255;
        EXPECT_NEAR(working.floats()[i], i % 4 == 3 ? v : srgb_decoded(v), 2e-5f);  // alpha stays
    }
    EXPECT_EQ(config.to_working(image, "data").pixels, to_float(image).pixels);
    EXPECT_EQ(config.to_working(Image(3, 3, 1, Image::Type::u16), "sRGB Texture").channels, 3);
    EXPECT_EQ(config.to_working(Image(3, 3, 2, Image::Type::u16), "sRGB Texture").channels, 4);
}

TEST(ColorErrors, NameWhatIsThere) {
    const ColorConfig config(kOwn);
    std::vector<float> rgb(3);
    const std::string view = message_of([&] { config.apply_display(rgb, "sRGB", "ACES 1.0 SRD"); });
    EXPECT_TRUE(contains(view, "did you mean 'ACES 1.0 SDR'?")) << view;
    EXPECT_TRUE(contains(view, "Rec.1886")) << view;
    EXPECT_TRUE(contains(view, "tyndall.ocio")) << view;
    EXPECT_TRUE(contains(message_of([&] { (void)config.display_shader("sRGBs", {}); }), "did you mean 'sRGB'?"));
    EXPECT_TRUE(contains(message_of([&] { (void)config.views("P3"); }), "unknown display 'P3'"));
    EXPECT_TRUE(contains(message_of([&] { (void)config.space_of_file("a.png", "ACEScq"); }), "did you mean 'ACEScg'"));
    EXPECT_TRUE(contains(message_of([&] { config.convert(std::span(rgb).first(2), "Raw", "Raw"); }), "triples"));
    EXPECT_TRUE(contains(message_of([] { ColorConfig("none.ocio"); }), "none.ocio: no such file"));
}

class ConfigFiles : public TemporaryFolder {};

TEST_F(ConfigFiles, TheEnvironmentChooses) {
    const char* before = std::getenv("OCIO");
    const std::string kept = before ? before : "";
    std::string text = paths::read_file(kOwn);
    text.replace(text.find("name: ACES 1.0 SDR, "), 19, "name: Mine,         ");
    text.replace(text.find("active_views: ["), 15, "active_views: [Mine, ");
    paths::write_file_atomically(folder_ / "mine.ocio", text);
    setenv("OCIO", (folder_ / "mine.ocio").c_str(), 1);
    EXPECT_EQ(ColorConfig().default_view(), "Mine");
    EXPECT_EQ(ColorConfig(kOwn).default_view(), "ACES 1.0 SDR");  // what is asked for wins
    before ? setenv("OCIO", kept.c_str(), 1) : unsetenv("OCIO");
}

/// Truncated and mutated configurations are errors that name the file, or configurations that work; never a crash.
TEST_F(ConfigFiles, BrokenConfigurationsAreErrors) {
    const std::string whole = paths::read_file(kOwn);
    const fs::path file = folder_ / "broken.ocio";
    const auto attempt = [&](const std::string& content) {
        std::ofstream(file, std::ios::binary) << content;
        return message_of([&] {
            const ColorConfig config(file);
            std::vector<float> rgb{0.1f, 0.2f, 0.3f};
            for (const std::string& display : config.displays())
                for (const std::string& view : config.views(display)) {
                    config.apply_display(rgb, display, view);
                    (void)config.display_shader(display, view);
                }
            (void)config.space_of_file("a_normal.png");
            config.convert(rgb, "scene_linear", config.color_spaces().front());
        });
    };
    EXPECT_EQ(attempt(whole), "");
    EXPECT_TRUE(contains(attempt(""), "broken.ocio"));
    EXPECT_TRUE(contains(attempt("hello"), "broken.ocio"));
    EXPECT_TRUE(contains(attempt(std::string(100000, '[')), "broken.ocio"));
    for (size_t i = 1; i < 40; ++i) {
        const size_t length = whole.size() * i / 44;  // up to where the last, unused colour space is described
        EXPECT_TRUE(contains(attempt(whole.substr(0, length)), "broken.ocio")) << "cut at " << length;
    }
    std::mt19937 random(9);
    int refused = 0;
    for (int i = 0; i < 150; ++i) {
        std::string mutated = whole;
        for (int k = 0; k < 4; ++k) mutated[random() % mutated.size()] = static_cast<char>(random() % 128);
        const std::string message = attempt(mutated);
        if (message.empty()) continue;
        ++refused;
        EXPECT_TRUE(contains(message, "broken.ocio")) << message;
    }
    EXPECT_GT(refused, 30);
}

/// What OpenColorIO's own Python binding answered for eleven colours in the views of the ACES configurations.
class References : public testing::Test {
 protected:
    void SetUp() override {
        const fs::path file = kShared / "reference_values_pyocio212.json";
        if (!fs::exists(file)) GTEST_SKIP() << "no " << file << ": the views are not compared with OpenColorIO's";
        values_ = nlohmann::json::parse(paths::read_file(file));
    }

    /// Compares one view of `config`; the samples are in `space`.
    void expect(const ColorConfig& config, const std::string& key, const std::string& space, const std::string& display,
                const std::string& view) {
        for (const auto& [name, expected] : values_["results"][key].items()) {
            auto rgb = values_["samples"][name].get<std::vector<float>>();
            config.convert(rgb, space, config.working_space());
            config.apply_display(rgb, display, view);
            for (size_t c = 0; c < 3; ++c) {
                const float wanted = expected[c].get<float>();
                EXPECT_NEAR(rgb[c], wanted, 1e-4f * std::max(1.0f, std::abs(wanted))) << key << ": " << name;
            }
        }
    }

    nlohmann::json values_;
};

TEST_F(References, OwnAcesViewIsTheAcesView) {
    const ColorConfig config(kOwn);
    const std::string prefix = "OpenColorIO/studio-config-v1.0.0_aces-v1.3_ocio-v2.1.ocio | ";
    for (const auto& [theirs, ours] : {std::pair{"Linear Rec.709 (sRGB)", "Linear Rec.709"}, {"ACEScg", "ACEScg"}}) {
        const std::string from = prefix + theirs + " -> sRGB - Display / ";
        expect(config, from + "ACES 1.0 - SDR Video", ours, "sRGB", "ACES 1.0 SDR");
        expect(config, from + "Un-tone-mapped", ours, "sRGB", "sRGB");
    }
    expect(config, prefix + "Linear Rec.709 (sRGB) -> sRGB - Display / Raw", "Linear Rec.709", "sRGB", "Raw");
}

TEST_F(References, UsersConfigurationsWork) {
    int compared = 0;
    for (const auto& [key, unused] : values_["results"].items()) {
        const size_t bar = key.find(" | "), arrow = key.find(" -> "), slash = key.find(" / ", arrow);
        const fs::path file = kShared / fs::path(key.substr(0, bar)).filename();
        const std::string view = key.substr(slash + 3);
        if (!fs::exists(file) || view == "Raw") continue;
        expect(ColorConfig(file), key, key.substr(bar + 3, arrow - bar - 3), key.substr(arrow + 4, slash - arrow - 4),
               view);
        ++compared;
    }
    EXPECT_GE(compared, 10);
}

TEST_F(References, UsersConfigurationsKnowOurFiles) {
    const ColorConfig config(kShared / "studio-config-v1.0.0_aces-v1.3_ocio-v2.1.ocio");
    EXPECT_EQ(config.working_space(), "ACEScg");
    EXPECT_EQ(config.space_of_file("stone.png"), "sRGB - Texture");
    EXPECT_EQ(config.space_of_file("noon.hdr"), "Linear Rec.709 (sRGB)");
    EXPECT_FALSE(config.decodes_as_srgb("sRGB - Texture"));  // other primaries than the working space
    std::vector<float> red{1, 0, 0};
    config.convert(red, "Linear Rec.709 (sRGB)", "scene_linear");
    EXPECT_NEAR(red[0], 0.613f, 0.001f);
    for (const std::string& view : config.views()) EXPECT_FALSE(config.display_shader({}, view).text.empty());
    // A newer configuration than the library: a clear error.
    const fs::path newer = kShared / "studio-config-v4.0.0_aces-v2.0_ocio-v2.5.ocio";
    if (fs::exists(newer)) {
        const std::string message = message_of([&] { ColorConfig{newer}; });
        EXPECT_TRUE(contains(message, "studio-config-v4.0.0")) << message;
    }
}

}  // namespace
}  // namespace tyndall
