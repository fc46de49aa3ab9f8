// Broken glTF files are errors: never a crash, a hang, or memory without end.

#include <sys/resource.h>

#include <random>

#include "gltf_fixture.h"
#include "scene/gltf_import.h"

namespace tyndall {
namespace {

class GltfFuzz : public GltfTest {
 protected:
    /// A file with something of everything.
    GltfWriter sample() {
        GltfWriter writer;
        const int positions = writer.floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, "VEC3");
        const int uvs = writer.floats({0, 0, 1, 0, 0, 1, 1, 1}, "VEC2");
        writer.root["accessors"][0]["sparse"] = {
            {"count", 1},
            {"indices", {{"bufferView", writer.view_of(std::vector<uint16_t>{3})}, {"componentType", 5123}}},
            {"values", {{"bufferView", writer.view_of(std::vector<float>{2, 2, 0})}}}};
        const int image = writer.add("images", {{"bufferView", writer.view(png(9, 8, 7))}, {"mimeType", "image/png"}});
        writer.root["samplers"] = {{{"magFilter", 9729}, {"wrapS", 33071}}};
        writer.add("textures", {{"source", image}, {"sampler", 0}});
        writer.add("materials",
                   {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}, {"roughnessFactor", 0.5}}},
                    {"normalTexture", {{"index", 0}, {"extensions", {{"KHR_texture_transform", {{"scale", {2, 2}}}}}}}},
                    {"extensions", {{"KHR_materials_volume", {{"thicknessTexture", {{"index", 0}}}}}}}});
        auto& primitive = writer.primitive({{"POSITION", positions}, {"TEXCOORD_0", uvs}});
        primitive["indices"] = writer.indices({0, 1, 2, 2, 1, 3});
        primitive["material"] = 0;
        writer.root["extensions"]["KHR_lights_punctual"]["lights"] = {
            {{"type", "spot"}, {"spot", {{"outerConeAngle", 0.3}}}}};
        writer.root["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.25}}}}};
        writer.root["nodes"][0]["children"] = {1, 2};
        writer.add("nodes", {{"camera", 0}, {"translation", {1, 2, 3}}});
        writer.add("nodes", {{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}, {"rotation", {0, 0, 0, 1}}});
        return writer;
    }

    /// Whether the file loads; anything but an Error fails the test by itself.
    bool loads(const std::string& content) {
        write("fuzz.gltf", content);
        std::vector<std::filesystem::path> sources;
        try {
            (void)import_gltf(folder_ / "fuzz.gltf", "fuzz", config_, sources);
            return true;
        } catch (const Error& error) {
            EXPECT_GT(std::string_view(error.what()).size(), 10u);
            return false;
        }
    }

    /// Changes a number, a piece, or a few bytes.
    void mutate(std::string& content, std::mt19937& random) {
        static const std::vector<std::string> kPieces{"-1",
                                                      "0",
                                                      "1",
                                                      "255",
                                                      "65536",
                                                      "4294967295",
                                                      "1e300",
                                                      "-1e9",
                                                      "null",
                                                      "[]",
                                                      "{}",
                                                      "\"x\"",
                                                      "99999999999999999999",
                                                      "5121",
                                                      "5126",
                                                      "\"VEC4\"",
                                                      "true",
                                                      ",",
                                                      "}",
                                                      "\\"};
        const size_t at = random() % content.size();
        switch (random() % 4) {
            case 0:
                content[at] = static_cast<char>(random() % 256);
                return;
            case 1: {  // same length, so that the chunks of a .glb stay whole
                const std::string& piece = kPieces[random() % kPieces.size()];
                const size_t begin = content.find_first_of("0123456789", at);
                if (begin == std::string::npos) return;
                const size_t end = content.find_first_not_of("0123456789.", begin);
                if (end == std::string::npos || piece.size() > end - begin) return;
                content.replace(begin, end - begin, piece + std::string(end - begin - piece.size(), ' '));
                return;
            }
            case 2: {
                const size_t begin = content.find_first_of("0123456789", at);
                if (begin == std::string::npos) return;
                content.replace(begin, content.find_first_not_of("0123456789.", begin) - begin,
                                kPieces[random() % kPieces.size()]);
                return;
            }
            default:
                content.erase(at, random() % 8);
        }
    }

    void mutate_often(const std::string& good, int times, unsigned seed) {
        ASSERT_TRUE(loads(good));
        std::mt19937 random(seed);
        int loaded = 0;
        for (int i = 0; i < times; ++i) {
            std::string content = good;
            for (size_t change = 0; change < 1 + random() % 3; ++change)
                if (!content.empty()) mutate(content, random);
            loaded += loads(content) ? 1 : 0;
        }
        EXPECT_GT(loaded, times / 100) << "some changes do no harm: else the files do not get far";
        EXPECT_LT(loaded, times * 9 / 10);
    }

    void TearDown() override {
        rusage usage{};
        getrusage(RUSAGE_SELF, &usage);
        EXPECT_LT(usage.ru_maxrss, 1 << 20) << "KiB at most";
        GltfTest::TearDown();
    }
};

TEST_F(GltfFuzz, TruncatedAnywhereItIsAnError) {
    GltfWriter writer = sample();
    const std::string binary = writer.glb();
    for (size_t size = 0; size < binary.size(); size += size < 100 ? 1 : 7) {
        EXPECT_FALSE(loads(binary.substr(0, size))) << size;
        std::string mended = binary.substr(0, size);  // a header that agrees lets the reader get further
        if (size < 12) continue;
        const auto length = static_cast<uint32_t>(size);
        std::memcpy(mended.data() + 8, &length, 4);
        (void)loads(mended);
    }
    const std::string text = writer.gltf();
    for (size_t size = 0; size + 2 < text.size(); size += 11) EXPECT_FALSE(loads(text.substr(0, size))) << size;
}

TEST_F(GltfFuzz, MutatedText) {
    mutate_often(sample().gltf(), 3000, 20261122);
}
TEST_F(GltfFuzz, MutatedBinary) {
    mutate_often(sample().glb(), 3000, 20261123);
}

}  // namespace
}  // namespace tyndall
