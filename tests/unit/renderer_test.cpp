// What must hold of every picture, whatever its path.

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>

#include "core/error.h"
#include "image/compare.h"
#include "renderer_fixture.h"

namespace tyndall {
namespace {

using test::add;
using test::looking;
using test::material;
using test::plane_mesh;
using test::scaled;
using test::sphere_mesh;
using test::translated;

uint64_t hash(const Image& image) {
    uint64_t value = 0xcbf29ce484222325ull;
    for (const std::byte byte : image.pixels) value = (value ^ uint64_t(byte)) * 0x100000001b3ull;
    return value;
}

TEST_F(RendererTest, BothPathsShowTheSame) {
    const RenderScene scene = test::spheres();
    const Image deferred = render(scene, {640, 360}, "display");
    renderer_->set_path("light_pre_pass");
    const Image light_pre_pass = render(scene, {640, 360}, "display");
    const FlipDifference flip = compare_flip(deferred, light_pre_pass);
    std::printf("FLIP between the paths: mean %.6f, worst block %.4f at %d %d\n", flip.mean, flip.worst_block,
                flip.worst_block_x, flip.worst_block_y);
    EXPECT_LE(flip.mean, 0.005);
    // the picture is no flat colour that anything would match
    const auto [darkest, brightest] = std::ranges::minmax(deferred.floats());
    EXPECT_GT(brightest - darkest, 0.5f);
}

TEST_F(RendererTest, RadianceIsLinearInLight) {
    RenderScene scene = test::spheres();
    const Image once = render(scene);
    for (Light& light : scene.lights) light.intensity *= 4.0f;
    scene.sky.radiance *= 4.0f;
    const Image four_times = render(scene);
    for (size_t i = 0; i < once.value_count(); ++i)
        ASSERT_NEAR(four_times.floats()[i], 4.0f * once.floats()[i], 1e-4f * four_times.floats()[i] + 1e-6f);
}

TEST_F(RendererTest, NothingIsInfinite) {
    RenderScene scene = test::spheres();
    scene.lights[0].intensity = glm::vec3(1.2e5f);  // the sun on smooth metal: beyond 16-bit floats
    float brightest = 0.0f;
    for (const std::string& path : Renderer::paths()) {
        renderer_->set_path(path);
        const Image image = render(scene);
        for (const float value : image.floats()) {
            ASSERT_TRUE(std::isfinite(value)) << path;
            ASSERT_GE(value, 0.0f) << path;
            brightest = std::max(brightest, value);
        }
    }
    EXPECT_GT(brightest, 65504.0f);
}

TEST_F(RendererTest, ASecondFrameHasTheSameBits) {
    const RenderScene scene = test::spheres();
    const Image first = render(scene, {320, 180}, "display");
    const Image second = render(scene, {320, 180}, "display");
    EXPECT_EQ(hash(first), hash(second));
    const Image other = render(test::spheres(), {320, 180}, "radiance");
    EXPECT_NE(hash(first), hash(other));
}

TEST_F(RendererTest, DISABLED_PrintHash) {
    std::printf("hash %016llx\n", (unsigned long long)hash(render(test::spheres(), {320, 180}, "radiance")));
}

/// The hash that this program prints with so many shading threads.
std::string hash_with_threads(int threads) {
    std::array<char, 256> self{};
    if (readlink("/proc/self/exe", self.data(), self.size() - 1) < 0) return {};
    const std::string command = "LP_NUM_THREADS=" + std::to_string(threads) + " '" + self.data() +
                                "' --gtest_also_run_disabled_tests --gtest_filter='*DISABLED_PrintHash' 2>/dev/null";
    FILE* output = popen(command.c_str(), "r");
    if (output == nullptr) return {};
    std::string found;
    std::array<char, 256> line{};
    while (fgets(line.data(), int(line.size()), output) != nullptr)
        if (std::strncmp(line.data(), "hash ", 5) == 0) found = line.data();
    pclose(output);
    return found;
}

TEST_F(RendererTest, ThreadsDoNotMatter) {
    const std::string one = hash_with_threads(1);
    EXPECT_NE(one, "");
    EXPECT_EQ(one, hash_with_threads(2));
    EXPECT_EQ(one, hash_with_threads(4));
}

TEST_F(RendererTest, AnEmptySceneIsTheSky) {
    RenderScene scene;
    for (const std::string& path : Renderer::paths()) {
        renderer_->set_path(path);
        const Image black = render(scene);
        for (const float value : black.floats()) ASSERT_EQ(value, 0.0f);
    }
    scene.sky.radiance = {1, 2, 3};
    EXPECT_EQ(centre(render(scene)), glm::vec3(1, 2, 3));
}

TEST_F(RendererTest, WithoutLightSurfacesAreBlackButForTheirEmission) {
    RenderScene scene;
    const auto glowing = material(glm::vec3(1.0f), 0.0f, 0.5f);
    glowing->emissive = {5, 70000, 0.25f};
    add(scene, sphere_mesh(), glowing, translated({0, 0, -4}));
    for (const std::string& path : Renderer::paths()) {
        renderer_->set_path(path);
        const glm::vec3 seen = centre(render(scene));
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], glowing->emissive[c], 1e-3f * glowing->emissive[c]);
    }
}

TEST_F(RendererTest, OneSidedSurfacesAreNotSeenFromBehind) {
    RenderScene scene;
    const auto glowing = material(glm::vec3(1.0f), 0.0f, 0.5f);
    glowing->emissive = glm::vec3(1.0f);
    add(scene, plane_mesh(), glowing, glm::mat4(1.0f));
    scene.camera.transform = looking({0, -3, 0.1f}, {0, 0, 0}, {0, 0, 1});
    EXPECT_EQ(centre(render(scene)).x, 0.0f);
    glowing->double_sided = true;
    EXPECT_EQ(centre(render(scene)).x, 1.0f);
    glowing->double_sided = false;
    scene.surfaces[0].transform = scaled({1, -1, 1});  // mirrored: its front is below now
    EXPECT_EQ(centre(render(scene)).x, 1.0f);
}

TEST_F(RendererTest, TheAlphaMaskCutsHoles) {
    RenderScene scene;
    const auto leaf = material(glm::vec3(1.0f), 0.0f, 0.5f);
    leaf->emissive = glm::vec3(1.0f);
    leaf->alpha_mode = AlphaMode::mask;
    auto holes = std::make_shared<TextureAsset>();
    holes->id = test::next_id();
    holes->image = Image(2, 1, 4, Image::Type::u8);  // left half open, right half there
    for (int c = 0; c < 8; ++c) holes->image.bytes()[size_t(c)] = c == 3 ? 0 : 255;
    holes->filter = TextureFilter::nearest;
    leaf->base_colour_texture.texture = holes;
    add(scene, plane_mesh(), leaf, glm::mat4(1.0f));
    scene.camera.transform = looking({0, 3, 0}, {0, 0, 0}, {0, 0, -1});
    const Image image = render(scene);
    EXPECT_EQ(image.at(image.width / 2 - 20, image.height / 2, 0), 0.0f);
    EXPECT_EQ(image.at(image.width / 2 + 20, image.height / 2, 0), 1.0f);
    leaf->base_colour_texture.uv_transform[2][0] = 0.5f;  // KHR_texture_transform: half a picture to the side
    const Image moved = render(scene);
    EXPECT_EQ(moved.at(image.width / 2 - 20, image.height / 2, 0), 1.0f);
    EXPECT_EQ(moved.at(image.width / 2 + 20, image.height / 2, 0), 0.0f);
}

TEST_F(RendererTest, UnknownNamesAreErrorsWithTheNearest) {
    const auto message = [](auto&& call) -> std::string {
        try {
            call();
        } catch (const Error& error) {
            return error.what();
        }
        return {};
    };
    EXPECT_NE(message([&] { renderer_->set_path("defered"); }).find("'deferred'"), std::string::npos);
    EXPECT_NE(message([&] { renderer_->show("gbuffer_norml"); }).find("'gbuffer_normal'"), std::string::npos);
    EXPECT_EQ(renderer_->path(), "deferred");
}

TEST_F(RendererTest, EveryTargetCanBeShown) {
    const RenderScene scene = test::spheres();
    const Image shown = render(scene, {160, 90}, "display");
    for (const std::string& path : Renderer::paths()) {
        renderer_->set_path(path);
        const std::vector<std::string> views = renderer_->views();
        EXPECT_GE(views.size(), 6u) << path;
        for (const std::string& name : views) {
            renderer_->show(name);
            const Image view = render(scene, {160, 90}, "display");
            const bool plain = name == "gbuffer_emissive" || name == "gbuffer_f0";  // the same all over, or nearly so
            const auto [darkest, brightest] = std::ranges::minmax(view.floats());
            EXPECT_TRUE(plain || brightest > darkest) << name;
            EXPECT_NE(hash(view), hash(shown)) << name;
        }
        renderer_->show("");
    }
    renderer_->set_path("deferred");
    EXPECT_EQ(hash(render(scene, {160, 90}, "display")), hash(shown));
}

/// Adds to the picture, or fails.
class AddingPass final : public Pass {
 public:
    [[nodiscard]] std::string_view name() const override { return "test.adding"; }
    void declare(PassDeclaration& declaration) override {
        declaration.stage(Stage::post).updates("radiance", "set to a constant");
        if (!missing.empty()) declaration.reads(missing, "not there");
    }
    void execute(PassContext& context) override {
        if (fails) throw Error("no");
        context.bind_targets();
        const_cast<gpu::Texture&>(context.texture("radiance")).clear(0, glm::vec4(7.0f));
    }
    std::string missing;
    bool fails = false;
};

TEST_F(RendererTest, MediaDimAndGlow) {
    RenderScene scene = test::spheres();
    renderer_->shaders().set_text("test/media.glsl",
                                  "MediaSegment test_media(vec2 uv, vec3 p) {\n"
                                  "    return MediaSegment(vec3(3.0, 2.0, 1.0), vec3(0.5, 0.25, 1.0));\n}\n");
    for (const std::string& path : Renderer::paths()) {
        renderer_->set_path(path);
        const Image clear = render(scene);
        renderer_->seams().add(Seam::media_segment,
                               {.name = "test", .include = "test/media.glsl", .function = "test_media"});
        const Image dim = render(scene);
        for (int y = 0; y < clear.height; y += 3)
            for (int x = 0; x < clear.width; x += 3) {
                ASSERT_NEAR(dim.at(x, y, 0), 0.5f * clear.at(x, y, 0) + 3.0f, 1e-5f * dim.at(x, y, 0));
                ASSERT_NEAR(dim.at(x, y, 1), 0.25f * clear.at(x, y, 1) + 2.0f, 1e-5f * dim.at(x, y, 1));
                ASSERT_NEAR(dim.at(x, y, 2), clear.at(x, y, 2) + 1.0f, 1e-5f * dim.at(x, y, 2));
            }
        renderer_->seams().remove(Seam::media_segment, "test");
        EXPECT_EQ(hash(render(scene)), hash(clear));
    }
}

TEST_F(RendererTest, PassesComeAndGo) {
    const RenderScene scene;
    AddingPass pass;
    renderer_->add_pass(&pass);
    EXPECT_EQ(centre(render(scene)).x, 7.0f);
    pass.fails = true;
    EXPECT_EQ(centre(render(scene)).x, 0.0f);
    EXPECT_NE(renderer_->problems().find("test.adding"), std::string::npos);
    pass.fails = false;
    EXPECT_EQ(centre(render(scene)).x, 7.0f);
    renderer_->remove_passes(std::array<Pass*, 1>{&pass});
    EXPECT_EQ(centre(render(scene)).x, 0.0f);
    pass.missing = "nonsense";
    renderer_->add_pass(&pass);
    EXPECT_EQ(centre(render(scene)).x, 0.0f);
    EXPECT_NE(renderer_->problems().find("nonsense"), std::string::npos);
    renderer_->remove_passes(std::array<Pass*, 1>{&pass});
}

}  // namespace
}  // namespace tyndall
