// The asset store: names, caches, reloading, and the colour spaces of textures.

#include <chrono>
#include <fstream>
#include <thread>

#include "color/color.h"
#include "core/error.h"
#include "core/log.h"
#include "core/paths.h"
#include "image/image_io.h"
#include "scene/asset_store.h"
#include "temporary_folder.h"

namespace tyndall {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

class Assets : public TemporaryFolder {
 protected:
    void SetUp() override {
        TemporaryFolder::SetUp();
        fs::create_directories(folder_ / "scene" / "textures");
        store_.set_base(folder_ / "scene");
        log::set_sink([this](log::Level level, std::string_view) { errors_ += level == log::Level::error ? 1 : 0; });
    }
    void TearDown() override {
        log::set_sink({});
        TemporaryFolder::TearDown();
    }

    void write(const std::string& name, std::string_view content) {
        std::ofstream(folder_ / "scene" / name, std::ios::binary) << content;
    }
    void write_png(const std::string& name, int channels, Image::Type type = Image::Type::u8) {
        Image image(2, 2, channels, type);
        for (size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = static_cast<std::byte>(128 + i);
        save_png(folder_ / "scene" / name, image);
    }
    std::string error_of(auto&& work) {
        try {
            work();
        } catch (const Error& error) {
            return error.what();
        }
        return "no error";
    }
    /// Waits until the store has noticed what was written.
    bool reloads() {
        for (int i = 0; i < 100; ++i) {
            if (store_.reload_changed()) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
        return false;
    }

    ColorConfig config_{paths::root() / "config" / "color" / "tyndall.ocio"};
    AssetStore store_{config_, fs::current_path()};
    int errors_ = 0;
};

TEST_F(Assets, NamesStayInTheirFolders) {
    write("a.obj", kTriangle);
    std::ofstream(folder_ / "outside.obj") << kTriangle;
    EXPECT_EQ(store_.mesh("a.obj")->mesh.triangle_count(), 1u);
    for (const char* name : {"../outside.obj", "/etc/passwd", "textures/../../outside.obj", "assets:../README.md", ""})
        EXPECT_NE(error_of([&] { (void)store_.mesh(name); }), "no error") << name;
    EXPECT_EQ(store_.resolve("a.obj"), fs::canonical(folder_ / "scene" / "a.obj"));
}

TEST_F(Assets, ErrorsNameTheFileAndTheNearestOne) {
    write("pew.obj", kTriangle);
    const std::string error = error_of([&] { (void)store_.mesh("pews.obj"); });
    EXPECT_NE(error.find("pews.obj"), std::string::npos) << error;
    EXPECT_NE(error.find("did you mean 'pew.obj'?"), std::string::npos) << error;
    write("broken.obj", "v 0 0\nf 1 2 3\n");
    EXPECT_NE(error_of([&] { (void)store_.mesh("broken.obj"); }).find("broken.obj"), std::string::npos);
    EXPECT_NE(error_of([&] { (void)store_.texture("pew.obj", TextureUse::colour); }).find("pew.obj"),
              std::string::npos);
}

TEST_F(Assets, AreLoadedOnce) {
    write("a.obj", kTriangle);
    const auto first = store_.mesh("a.obj");
    EXPECT_EQ(store_.mesh("a.obj"), first);
    EXPECT_EQ(store_.mesh("./a.obj"), first) << "by the file, not by its spelling";
    EXPECT_NE(first->id, 0u);
    EXPECT_EQ(first->mesh.normals.size(), 3u);
    EXPECT_EQ(first->mesh.tangents.size(), 3u);
    write_png("t.png", 3);
    const auto colour = store_.texture("t.png", TextureUse::colour);
    const auto data = store_.texture("t.png", TextureUse::data);
    EXPECT_EQ(store_.texture("t.png", TextureUse::colour), colour);
    EXPECT_NE(colour->id, data->id);
}

TEST_F(Assets, ColoursStaySmallWhereTheGpuDecodesThem) {
    write_png("t.png", 3);
    const auto colour = store_.texture("t.png", TextureUse::colour);
    EXPECT_EQ(colour->image.type, Image::Type::u8);
    EXPECT_TRUE(colour->srgb_encoded);
    EXPECT_EQ(colour->filter, TextureFilter::trilinear);
    EXPECT_EQ(colour->wrap_u, TextureWrap::repeat);
}

TEST_F(Assets, DataKeepsItsNumbers) {
    write_png("t.png", 1);
    const auto data = store_.texture("t.png", TextureUse::data);
    EXPECT_EQ(data->image.type, Image::Type::u8);
    EXPECT_FALSE(data->srgb_encoded);
    EXPECT_EQ(data->image.bytes()[1], 129);
    write_png("deep.png", 1, Image::Type::u16);
    const auto deep = store_.texture("deep.png", TextureUse::data);
    ASSERT_EQ(deep->image.type, Image::Type::f32);
    EXPECT_NEAR(deep->image.at(0, 0, 0), static_cast<float>(0x8180) / 65535.0f, 1e-6f);
}

TEST_F(Assets, DeepColoursAreConverted) {
    write_png("deep.png", 3, Image::Type::u16);
    const auto colour = store_.texture("deep.png", TextureUse::colour);
    ASSERT_EQ(colour->image.type, Image::Type::f32);
    EXPECT_FALSE(colour->srgb_encoded);
    std::vector<float> expected{0x8180 / 65535.0f, 0x8382 / 65535.0f, 0x8584 / 65535.0f};
    config_.convert(expected, config_.space_of_file("deep.png"), config_.working_space());
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(colour->image.at(0, 0, c), expected[static_cast<size_t>(c)], 1e-5f);
}

TEST_F(Assets, ProbesAreFiniteAndOfThreeChannels) {
    Image image(4, 2, 4, Image::Type::f32);
    image.at(1, 0, 0) = std::numeric_limits<float>::infinity();
    image.at(2, 0, 1) = std::numeric_limits<float>::quiet_NaN();
    image.at(3, 1, 2) = 12.5f;
    save_exr(folder_ / "scene" / "probe.exr", image);
    const auto probe = store_.texture("probe.exr", TextureUse::probe);
    ASSERT_EQ(probe->image.channels, 3);
    EXPECT_FLOAT_EQ(probe->image.at(1, 0, 0), 65504.0f);
    EXPECT_FLOAT_EQ(probe->image.at(2, 0, 1), 0.0f);
    EXPECT_NEAR(probe->image.at(3, 1, 2), 12.5f, 1e-3f);
}

TEST_F(Assets, ChangedFilesAreReloaded) {
    write("a.obj", kTriangle);
    const auto before = store_.mesh("a.obj");
    EXPECT_FALSE(store_.reload_changed());
    write("a.obj", std::string(kTriangle) + "v 0 0 1\nf 1 2 4\n");
    EXPECT_TRUE(reloads());
    const auto after = store_.mesh("a.obj");
    EXPECT_NE(after->id, before->id);
    EXPECT_EQ(after->mesh.triangle_count(), 2u);
    EXPECT_EQ(before->mesh.triangle_count(), 1u) << "whoever holds the old one keeps it";
}

TEST_F(Assets, ABrokenFileKeepsTheLastGoodOne) {
    write_png("t.png", 3);
    const auto before = store_.texture("t.png", TextureUse::colour);
    write("t.png", "not a picture");
    for (int i = 0; i < 30; ++i) {
        EXPECT_FALSE(store_.reload_changed());
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    EXPECT_EQ(store_.texture("t.png", TextureUse::colour), before);
    EXPECT_EQ(errors_, 1) << "said once";
    write_png("t.png", 4);
    EXPECT_TRUE(reloads());
    EXPECT_EQ(store_.texture("t.png", TextureUse::colour)->image.channels, 4);
}

TEST_F(Assets, WhatWasMissingOrBrokenIsTriedAgain) {
    EXPECT_NE(error_of([&] { (void)store_.mesh("late.obj"); }), "no error");
    write("wrong.obj", "f 1 2 3\n");
    EXPECT_NE(error_of([&] { (void)store_.mesh("wrong.obj"); }), "no error");
    write("late.obj", kTriangle);
    EXPECT_NE(error_of([&] { (void)store_.mesh("late.obj"); }), "no error") << "remembered until reload_changed";
    EXPECT_TRUE(reloads());
    EXPECT_EQ(store_.mesh("late.obj")->mesh.triangle_count(), 1u);
    write("wrong.obj", kTriangle);
    EXPECT_TRUE(reloads());
    EXPECT_EQ(store_.mesh("wrong.obj")->mesh.triangle_count(), 1u);
}

TEST_F(Assets, CollectFreesWhatNobodyHolds) {
    write("a.obj", kTriangle);
    write("b.obj", kTriangle);
    const auto held = store_.mesh("a.obj");
    std::weak_ptr<const MeshAsset> loose = store_.mesh("b.obj");
    store_.collect();
    EXPECT_EQ(store_.mesh("a.obj"), held);
    EXPECT_TRUE(loose.expired());
    EXPECT_EQ(store_.mesh("b.obj")->mesh.triangle_count(), 1u);
}

TEST_F(Assets, AnotherBaseMeansOtherFiles) {
    write("a.obj", kTriangle);
    const auto here = store_.mesh("a.obj");
    fs::create_directories(folder_ / "other");
    std::ofstream(folder_ / "other" / "a.obj") << kTriangle << "v 0 0 1\nf 1 2 4\n";
    store_.set_base(folder_ / "other");
    EXPECT_EQ(store_.mesh("a.obj")->mesh.triangle_count(), 2u);
    store_.set_base(folder_ / "scene");
    EXPECT_EQ(store_.mesh("a.obj"), here);
}

TEST_F(Assets, VolumesAreSharedByGridAndReloadWithTheirRawFile) {
    write("v.raw", std::string(8, '\xff'));
    write("v.json", R"({"raw": "v.raw", "type": "u8", "size": [2, 2, 2]})");
    const auto volume = store_.volume("v.json", "");
    EXPECT_EQ(volume->volume.at(1, 1, 1), 1.0f);
    EXPECT_NE(volume->id, 0u);
    EXPECT_EQ(store_.volume("v.json", "density"), volume) << "the default has a name";
    EXPECT_EQ(store_.volume("v.json", ""), volume);
    EXPECT_NE(error_of([&] { (void)store_.volume("w.json", ""); }).find("did you mean 'v.json'?"), std::string::npos);
    write("v.raw", std::string(8, '\0'));
    ASSERT_TRUE(reloads());
    EXPECT_EQ(store_.volume("v.json", "")->volume.at(1, 1, 1), 0.0f);
    EXPECT_NE(store_.volume("v.json", "")->id, volume->id);
    write("v.json", "{}");
    reloads();
    EXPECT_EQ(store_.volume("v.json", "")->volume.at(1, 1, 1), 0.0f) << "the last good one stays";
    EXPECT_EQ(errors_, 1);
}

TEST_F(Assets, PhaseTablesAreNormalisedPerChannel) {
    write("flat.txt", "# angle r g b\n0 1 2 4\n90, 1, 2, 4\n180\t1 2 4 # the end\n");
    const auto flat = store_.phase_table("flat.txt");
    ASSERT_EQ(flat->values.size(), 3u);
    for (const glm::vec3& value : flat->values)
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(value[i], 0.25 / 3.14159265, 1e-7);
    // linear in the angle from 1 to 0: 2 pi integral (1 - t / pi) sin t dt = 2 pi
    write("ramp.txt", "0 5\n180 0\n");
    const auto ramp = store_.phase_table("ramp.txt");
    ASSERT_EQ(ramp->values.size(), 2u);
    EXPECT_NEAR(ramp->values[0].x, 0.5 / 3.14159265, 1e-6);
    write("uneven.txt", "0 5\n45 4\n180 1\n");
    EXPECT_EQ(store_.phase_table("uneven.txt")->values.size(), 5u) << "as fine as its finest step";

    const auto error = [&](const char* text) {
        write("bad.txt", text);
        AssetStore fresh(config_, folder_ / "scene");
        return error_of([&] { (void)fresh.phase_table("bad.txt"); });
    };
    for (const auto& [text, part] : {std::pair{"0 1\n", "too early"},
                                     {"0 1\n90 1\n80 1\n", "bad.txt:3"},
                                     {"5 1\n180 1\n", "not 0"},
                                     {"0 1\n180 x\n", "'x'"},
                                     {"0 -1\n180 1\n", "out of range"},
                                     {"0 0\n180 0\n", "scatters nothing"},
                                     {"0 1 2\n180 1 2\n", "3 numbers"},
                                     {"0 1\n180 nan\n", "'nan'"},
                                     {"", "too early"}})
        EXPECT_NE(error(text).find(part), std::string::npos) << error(text);
}

}  // namespace
}  // namespace tyndall
