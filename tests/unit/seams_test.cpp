#include <gmock/gmock.h>

#include "core/error.h"
#include "gpu_fixture.h"
#include "render/seams.h"

namespace tyndall {
namespace {

using testing::ElementsAre;

/// For what looks at no frame.
class NoContext final : public PassContext {
 public:
    [[nodiscard]] const gpu::Texture& texture(std::string_view target) const override {
        throw Error(std::string(target));
    }
    [[nodiscard]] const gpu::Texture* find_texture(std::string_view) const override { return nullptr; }
    void bind_targets() override {}
    void bind_targets(std::span<const std::string_view>, int, int) override {}
    [[nodiscard]] glm::ivec2 size() const override { return glm::ivec2(8); }
    [[nodiscard]] Frame& frame() override { throw Error("no frame"); }
};

/// Draws one pixel with a fragment shader and reads it back.
class SeamsTest : public GpuTest {
 protected:
    void SetUp() override {
        GpuTest::SetUp();
        shaders_ = std::make_unique<gpu::ShaderLibrary>();
        seams_ = std::make_unique<Seams>(*shaders_);
        write("light", "light_transmittance", "vec4(light_transmittance(3u, vec3(1.0), vec3(0.0)), 1.0)");
        write("indirect", "indirect_light",
              "vec4(indirect_light(vec3(0), vec3(0, 1, 0), vec3(0, 1, 0), 0.5).irradiance, "
              "indirect_light(vec3(0), vec3(0, 1, 0), vec3(0, 1, 0), 0.5).specular.x)");
        write("media", "media_segment",
              "vec4(media_segment(vec2(0.5), vec3(0)).in_scatter, media_segment(vec2(0.5), vec3(0)).transmittance.x)");
        write("sky", "sky", "vec4(sky_radiance(vec3(0, 1, 0)), 1.0)");
        write("model", "shading_model",
              "vec4(shade(MODEL, ShadingPoint(vec3(0), vec3(0, 0, 1), vec3(0, 0, 1), 0.5, MODEL, vec2(0)), "
              "LightSample(vec3(0, 0, 1), vec3(2.0), vec3(1.0), vec3(2.0), 0u)).diffuse, 1.0)");
    }
    void TearDown() override {
        seams_.reset();
        shaders_.reset();
        GpuTest::TearDown();
    }

    void write(const std::string& name, const std::string& seam, const std::string& expression) {
        shaders_->set_text(
            "test/" + name + ".frag",
            "#include \"seams/" + seam + ".glsl\"\nout vec4 result;\nvoid main() { result = " + expression + "; }\n");
    }
    /// A provider whose function has this body.
    SeamProvider provider(const std::string& name, const std::string& signature, const std::string& body) {
        shaders_->set_text("test/" + name + ".glsl",
                           "#include \"render/shaders/seam_types.glsl\"\n" + signature + " { " + body + " }\n");
        const size_t start = signature.find(' ') + 1;
        return {name, "test/" + name + ".glsl", signature.substr(start, signature.find('(') - start), {}, {}};
    }
    SeamProvider transmittance(const std::string& name, const std::string& value) {
        return provider(name, "vec3 " + name + "_transmittance(uint light, vec3 p, vec3 n)",
                        "return vec3(" + value + ");");
    }
    glm::vec4 draw(const std::string& name, const std::vector<std::string>& defines = {}) {
        gpu::Texture target({.format = gpu::Format::rgba32f}, "target");
        const gpu::Framebuffer::Attachment attachment{&target};
        gpu::Framebuffer framebuffer(std::span(&attachment, 1), {}, "target");
        framebuffer.bind();
        shaders_->program({.name = name, .fragment = "test/" + name + ".frag", .defines = defines}).use();
        gpu::draw_fullscreen();
        return target.read().at(0);
    }

    std::unique_ptr<gpu::ShaderLibrary> shaders_;
    std::unique_ptr<Seams> seams_;
};

TEST_F(SeamsTest, WithoutProvidersTheyAreNeutral) {
    EXPECT_EQ(draw("light"), glm::vec4(1.0f));
    EXPECT_EQ(draw("indirect"), glm::vec4(0.0f));
    EXPECT_EQ(draw("media"), glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
    EXPECT_EQ(draw("sky"), glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
}

TEST_F(SeamsTest, TransmittanceIsAProductAndFollowsItsProviders) {
    seams_->add(Seam::light_transmittance, transmittance("glass", "0.5, 0.25, 1.0"));
    seams_->add(Seam::light_transmittance, transmittance("cloud", "0.5"));
    EXPECT_EQ(draw("light"), glm::vec4(0.25f, 0.125f, 0.5f, 1.0f));
    EXPECT_THAT(seams_->providers(Seam::light_transmittance), ElementsAre("glass", "cloud"));
    const uint64_t version = seams_->version();
    seams_->remove(Seam::light_transmittance, "glass");
    EXPECT_GT(seams_->version(), version);
    EXPECT_EQ(draw("light"), glm::vec4(0.5f, 0.5f, 0.5f, 1.0f));
}

TEST_F(SeamsTest, IndirectLightIsASum) {
    const std::string signature = "(vec3 p, vec3 n, vec3 v, float roughness)";
    seams_->add(Seam::indirect_light, provider("a", "IndirectLight a_indirect" + signature,
                                               "return IndirectLight(vec3(1, 2, 3), vec3(roughness));"));
    seams_->add(Seam::indirect_light,
                provider("b", "IndirectLight b_indirect" + signature, "return IndirectLight(n, vec3(1.0));"));
    EXPECT_EQ(draw("indirect"), glm::vec4(1.0f, 3.0f, 3.0f, 1.5f));
}

TEST_F(SeamsTest, MediaStandOneBehindTheOther) {
    const std::string signature = "(vec2 uv, vec3 p)";
    seams_->add(Seam::media_segment,
                provider("a", "MediaSegment a_segment" + signature, "return MediaSegment(vec3(1.0), vec3(0.5));"));
    seams_->add(Seam::media_segment,
                provider("b", "MediaSegment b_segment" + signature, "return MediaSegment(vec3(4.0), vec3(0.25));"));
    EXPECT_EQ(draw("media"), glm::vec4(3.0f, 3.0f, 3.0f, 0.125f));
}

TEST_F(SeamsTest, TheLastSkyWins) {
    seams_->add(Seam::sky, provider("a", "vec3 a_sky(vec3 direction)", "return vec3(1.0);"));
    seams_->add(Seam::sky, provider("b", "vec3 b_sky(vec3 direction)", "return direction * 2.0;"));
    EXPECT_EQ(draw("sky"), glm::vec4(0.0f, 2.0f, 0.0f, 1.0f));
}

TEST_F(SeamsTest, ShadingModelsAreChosenByNumber) {
    const auto model = [&](const std::string& name, const std::string& value) {
        return provider(name, "LightTerms " + name + "_shading_model(ShadingPoint s, LightSample l)",
                        "LightTerms terms = no_light(); terms.diffuse = vec3(" + value + "); return terms;");
    };
    seams_->add(Seam::shading_model, model("skin", "7.0"));
    seams_->add(Seam::shading_model, model("hair", "9.0"));
    EXPECT_EQ(seams_->shading_model("standard"), 0u);
    EXPECT_EQ(seams_->shading_model("no such model"), 0u);
    EXPECT_EQ(seams_->shading_model("hair"), 2u);
    EXPECT_EQ(draw("model", {"MODEL 0u"}), glm::vec4(2.0f, 2.0f, 2.0f, 1.0f));
    EXPECT_EQ(draw("model", {"MODEL 1u"}).x, 7.0f);
    EXPECT_EQ(draw("model", {"MODEL 2u"}).x, 9.0f);
    EXPECT_EQ(draw("model", {"MODEL 3u"}).x, 2.0f) << "unknown numbers are standard";
    seams_->remove(Seam::shading_model, "skin");
    EXPECT_EQ(seams_->shading_model("hair"), 2u) << "numbers stay while others leave";
    EXPECT_EQ(draw("model", {"MODEL 1u"}).x, 2.0f);
    seams_->remove(Seam::shading_model, "standard");
    EXPECT_THAT(seams_->providers(Seam::shading_model), ElementsAre("standard", "hair"));
}

TEST_F(SeamsTest, ProgramsHaveTheModelsThatTheyChoose) {
    SeamProvider leaf = provider("leaf", "LightTerms leaf_shading_model(ShadingPoint s, LightSample l)",
                                 "LightTerms terms = no_light(); terms.diffuse = vec3(7.0); return terms;");
    shaders_->set_text("test/leaf_receiver.glsl",
                       "#include \"test/leaf.glsl\"\nLightReceiver leaf_receiver(ShadingPoint s, vec3 to_light) { "
                       "return LightReceiver(s.position + 3.0, -s.normal); }\n");
    leaf.include = "test/leaf_receiver.glsl";
    leaf.receiver = "leaf_receiver";
    leaf.use = [](PassContext&) { return ShadingModelUse{{"LEAF"}, {glm::ivec2(2), glm::ivec2(3)}}; };
    SeamProvider hair = leaf;
    hair.name = "hair";
    hair.use = [](PassContext&) { return ShadingModelUse{{"HAIR"}, {}}; };
    seams_->add(Seam::shading_model, leaf);
    seams_->add(Seam::shading_model, hair);
    NoContext context;
    const ShadingModelUse use = seams_->shading_models(context);
    EXPECT_THAT(use.defines, ElementsAre(kStandardModelOnly, "SHADING_MODEL_1", "LEAF"));
    EXPECT_EQ(use.pixels.size, glm::ivec2(3));

    EXPECT_EQ(draw("model", {"MODEL 1u"}).x, 7.0f) << "without a choice there are all";
    EXPECT_EQ(draw("model", {"MODEL 1u", kStandardModelOnly}).x, 2.0f);
    EXPECT_EQ(draw("model", {"MODEL 1u", kStandardModelOnly, "SHADING_MODEL_1"}).x, 7.0f);
    write("receiver", "shading_model",
          "vec4(light_receiver(MODEL, ShadingPoint(vec3(1), vec3(0, 0, 1), vec3(0, 0, 1), 0.5, MODEL, vec2(0)), "
          "vec3(0, 0, 1)).position.x, light_receiver(MODEL, ShadingPoint(vec3(1), vec3(0, 0, 1), vec3(0, 0, 1), 0.5, "
          "MODEL, vec2(0)), vec3(0, 0, 1)).normal)");
    EXPECT_EQ(draw("receiver", {"MODEL 0u"}), glm::vec4(1.0f, 0.0f, 0.0f, 1.0f));
    EXPECT_EQ(draw("receiver", {"MODEL 1u"}), glm::vec4(4.0f, 0.0f, 0.0f, -1.0f));
    EXPECT_EQ(draw("receiver", {"MODEL 1u", kStandardModelOnly}), glm::vec4(1.0f, 0.0f, 0.0f, 1.0f));
}

TEST(PixelRectangles, TheOutsideIsAllElseOnce) {
    const glm::ivec2 size(7, 5);
    for (const PixelRectangle& rectangle :
         {PixelRectangle{}, PixelRectangle{{0, 0}, size}, PixelRectangle{{2, 1}, {3, 2}},
          PixelRectangle{{0, 3}, {7, 2}}, PixelRectangle{{6, 0}, {1, 5}}}) {
        std::vector<int> covered(35, 0);
        const auto cover = [&](const PixelRectangle& one) {
            for (int y = one.low.y; y < one.low.y + one.size.y; ++y)
                for (int x = one.low.x; x < one.low.x + one.size.x; ++x) ++covered.at(size_t(y * size.x + x));
        };
        cover(rectangle);
        for (const PixelRectangle& one : outside(rectangle, size)) {
            EXPECT_FALSE(one.empty());
            cover(one);
        }
        EXPECT_THAT(covered, testing::Each(1));
    }
    const PixelRectangle both = united({{1, 2}, {2, 2}}, {{4, 0}, {1, 1}});
    EXPECT_EQ(both.low, glm::ivec2(1, 0));
    EXPECT_EQ(both.size, glm::ivec2(4, 4));
    EXPECT_EQ(united({}, both).size, both.size);
    EXPECT_EQ(united(both, {}).low, both.low);
}

TEST_F(SeamsTest, NamesAreUniqueAndReadsAreDeclared) {
    SeamProvider glass = transmittance("glass", "1.0");
    glass.reads = {"glass_depth"};
    seams_->add(Seam::light_transmittance, glass);
    EXPECT_THROW(seams_->add(Seam::light_transmittance, glass), Error);
    PassDeclaration declaration;
    declaration.reads("glass_depth", "by the pass itself");
    seams_->declare(Seam::light_transmittance, declaration);
    ASSERT_EQ(declaration.accesses_.size(), 1u);
    EXPECT_EQ(declaration.accesses_[0].target, "glass_depth");
}

}  // namespace
}  // namespace tyndall
