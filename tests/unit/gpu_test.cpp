#include "gpu/gpu.h"

#include <array>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <glm/packing.hpp>

#include "core/error.h"
#include "gpu_fixture.h"

namespace tyndall::gpu {
namespace {

using GpuObjects = GpuTest;

/// The value `v` of a texel as upload() takes it.
std::vector<std::byte> packed(Format format, glm::vec4 v) {
    std::vector<std::byte> out(bytes_per_texel(format));
    const auto put = [&](auto value) {
        EXPECT_EQ(sizeof value, out.size()) << name_of(format);
        std::memcpy(out.data(), &value, std::min(sizeof value, out.size()));
    };
    switch (format) {
        case Format::r8:
            put(glm::packUnorm1x8(v.x));
            break;
        case Format::rg8:
            put(glm::packUnorm2x8({v.x, v.y}));
            break;
        case Format::rgba8:
        case Format::srgb8_alpha8:
            put(glm::packUnorm4x8(v));
            break;
        case Format::r16:
            put(glm::packUnorm1x16(v.x));
            break;
        case Format::rg16:
            put(glm::packUnorm2x16({v.x, v.y}));
            break;
        case Format::rgba16:
            put(glm::packUnorm4x16(v));
            break;
        case Format::r16f:
            put(glm::packHalf1x16(v.x));
            break;
        case Format::rg16f:
            put(glm::packHalf2x16({v.x, v.y}));
            break;
        case Format::rgba16f:
            put(glm::packHalf4x16(v));
            break;
        case Format::r32f:
        case Format::depth32f:
            put(v.x);
            break;
        case Format::rg32f:
            put(glm::vec2(v.x, v.y));
            break;
        case Format::rgba32f:
            put(v);
            break;
        case Format::r11g11b10f:
            put(glm::packF2x11_1x10({v.x, v.y, v.z}));
            break;
        case Format::r32ui:
            put(static_cast<uint32_t>(v.x));
            break;
        case Format::rgb10_a2:
            put(glm::packUnorm3x10_1x2(v));
            break;
    }
    return out;
}

int channels(Format format) {
    switch (format) {
        case Format::r8:
        case Format::r16:
        case Format::r16f:
        case Format::r32f:
        case Format::r32ui:
        case Format::depth32f:
            return 1;
        case Format::rg8:
        case Format::rg16:
        case Format::rg16f:
        case Format::rg32f:
            return 2;
        case Format::r11g11b10f:
            return 3;
        default:
            return 4;
    }
}

class EveryFormat : public GpuTest, public testing::WithParamInterface<int> {};

TEST_P(EveryFormat, UploadsAndReadsBackEveryShape) {
    const auto format = static_cast<Format>(GetParam());
    const float scale = format == Format::r32ui ? 1000.0f : 1.0f;
    for (const Shape shape : {Shape::flat, Shape::array, Shape::volume, Shape::cube, Shape::cube_array}) {
        if (is_depth(format) && shape == Shape::volume) continue;  // GL has none
        Texture texture({shape, format, 4, 4, shape == Shape::flat || shape == Shape::cube ? 1 : 2, 2}, "test");
        const int layer = shape == Shape::flat ? 0 : (shape == Shape::cube_array ? 11 : 1);
        const int mip = shape == Shape::volume ? 0 : 1;
        const int texels = mip == 0 ? 16 : 4;
        std::vector<std::byte> upload;
        std::vector<glm::vec4> expected;
        for (int i = 0; i < texels; ++i) {
            const float t = static_cast<float>(i + 1) / static_cast<float>(texels + 1);
            const glm::vec4 value = glm::vec4(t, 1.0f - t, 0.5f * t, 1.0f) * scale;
            const auto bytes = packed(format, value);
            upload.insert(upload.end(), bytes.begin(), bytes.end());
            glm::vec4 kept(0.0f, 0.0f, 0.0f, 1.0f);
            for (int c = 0; c < channels(format); ++c) kept[c] = value[c];
            if (format == Format::r32ui) kept.x = std::floor(value.x);
            expected.push_back(kept);
        }
        texture.upload(mip, layer, upload.data());
        const std::vector<glm::vec4> got = texture.read(mip, layer);
        ASSERT_EQ(got.size(), expected.size());
        for (size_t i = 0; i < got.size(); ++i)
            for (int c = 0; c < 4; ++c)  // 6 bits of mantissa in r11g11b10f, 8 bits in rgba8
                EXPECT_NEAR(got[i][c], expected[i][c], 1.0f / 127.0f)
                    << name_of(format) << " shape " << static_cast<int>(shape) << " texel " << i << " channel " << c;
    }
}

TEST_P(EveryFormat, ClearsToAValue) {
    const auto format = static_cast<Format>(GetParam());
    Texture texture({Shape::array, format, 3, 2, 2, 1}, "test");
    texture.clear(0, {1.0f, 1.0f, 1.0f, 1.0f});
    for (const glm::vec4& texel : texture.read(0, 1)) {
        EXPECT_EQ(texel.x, 1.0f);
        EXPECT_EQ(texel.w, 1.0f);
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, EveryFormat, testing::Range(0, static_cast<int>(Format::depth32f) + 1),
                         [](const auto& tested) { return std::string(name_of(static_cast<Format>(tested.param))); });

TEST_F(GpuObjects, BuffersUpdateAndReadBack) {
    const std::array<float, 4> first{1, 2, 3, 4};
    Buffer buffer(std::span<const float>(first), "test");
    EXPECT_EQ(buffer.size(), sizeof first);
    const float changed = 9.0f;
    buffer.update(4, sizeof changed, &changed);
    std::array<float, 4> got{};
    buffer.read(0, sizeof got, got.data());
    EXPECT_EQ(got, (std::array<float, 4>{1, 9, 3, 4}));
    const Buffer empty(0, nullptr, "empty");
    EXPECT_EQ(empty.size(), 0u);
}

TEST_F(GpuObjects, TheTallyFollowsMoves) {
    const Alive start = alive();
    {
        Texture a({Shape::flat, Format::rgba16f, 8, 8, 1, 0}, "a");
        EXPECT_EQ(a.desc().mips, 4);
        EXPECT_EQ(alive().texture_bytes - start.texture_bytes, size_t{8 * (64 + 16 + 4 + 1)});
        a = Texture({Shape::flat, Format::r8, 2, 2}, "b");
        EXPECT_EQ(alive().texture_bytes - start.texture_bytes, size_t{4});
        Texture c(std::move(a));
        EXPECT_EQ(c.desc().format, Format::r8);
        Buffer buffer(100, nullptr, "buffer");
        buffer = Buffer(10, nullptr, "smaller");
        EXPECT_EQ(alive().buffer_bytes - start.buffer_bytes, size_t{10});
        EXPECT_EQ(alive().textures - start.textures, 1);
    }
    EXPECT_EQ(alive(), start);
}

TEST_F(GpuObjects, ImpossibleTexturesAreErrors) {
    EXPECT_THROW(Texture({Shape::flat, Format::r8, 0, 4}, "none"), Error);
    EXPECT_THROW(Texture({Shape::flat, Format::r8, 1 << 28, 4}, "huge"), Error);
    EXPECT_THROW(Texture({Shape::cube, Format::r8, 4, 8}, "oblong"), Error);
}

TEST_F(GpuObjects, MipsAverage) {
    Texture texture({Shape::flat, Format::r32f, 2, 2, 1, 0}, "test");
    const std::array<float, 4> texels{0, 1, 2, 5};
    texture.upload(0, 0, texels.data());
    texture.generate_mips();
    EXPECT_NEAR(texture.read(1)[0].x, 2.0f, 1e-5f);
}

TEST_F(GpuObjects, FramebuffersReachOneLayerAndOneMip) {
    Texture layers({Shape::array, Format::rgba32f, 8, 8, 3, 2}, "layers");
    Texture depth({Shape::flat, Format::depth32f, 4, 4}, "depth");
    for (int layer = 0; layer < 3; ++layer) layers.clear(1, glm::vec4(0.0f));
    const std::array<Framebuffer::Attachment, 1> colours{{{&layers, 1, 2}}};
    const Framebuffer target(colours, {&depth}, "target");
    EXPECT_EQ(target.size(), glm::ivec2(4, 4));
    target.clear_colour(0, {1, 2, 3, 4});
    target.clear_depth(0.25f);
    EXPECT_EQ(layers.read(1, 2)[5], glm::vec4(1, 2, 3, 4));
    EXPECT_EQ(layers.read(1, 1)[5], glm::vec4(0.0f));
    EXPECT_EQ(depth.read()[15].x, 0.25f);
}

TEST_F(GpuObjects, IncompleteFramebuffersAreErrors) {
    Texture small({Shape::flat, Format::rgba8, 2, 2}, "small");
    Texture depth({Shape::flat, Format::depth32f, 4, 4}, "depth");
    const std::array<Framebuffer::Attachment, 1> colours{{{&small}}};
    EXPECT_THROW(Framebuffer(colours, {&depth}, "sizes"), Error);
    EXPECT_THROW(Framebuffer({}, {}, "nothing"), Error);
}

TEST_F(GpuObjects, SamplersAreShared) {
    EXPECT_EQ(sampler({.filter = Filter::nearest}), sampler({.filter = Filter::nearest}));
    EXPECT_NE(sampler({.filter = Filter::nearest}), sampler({.filter = Filter::linear}));
    EXPECT_NE(sampler({.anisotropy = 8.0f}), 0u);
}

}  // namespace
}  // namespace tyndall::gpu
