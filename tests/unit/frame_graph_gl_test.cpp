#include <epoxy/gl.h>
#include <gmock/gmock.h>

#include <functional>

#include "core/error.h"
#include "gpu_fixture.h"
#include "render/frame_graph.h"

namespace tyndall {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class TestPass final : public Pass {
 public:
    TestPass(std::string name, std::function<void(PassDeclaration&)> declare, std::function<void(PassContext&)> execute)
        : name_(std::move(name)), declare_(std::move(declare)), execute_(std::move(execute)) {}
    [[nodiscard]] std::string_view name() const override { return name_; }
    void declare(PassDeclaration& declaration) override { declare_(declaration); }
    void execute(PassContext& context) override { execute_(context); }

 private:
    std::string name_;
    std::function<void(PassDeclaration&)> declare_;
    std::function<void(PassContext&)> execute_;
};

void fill(PassContext& context, glm::vec4 colour) {
    context.bind_targets();
    glClearColor(colour.x, colour.y, colour.z, colour.w);
    glClear(GL_COLOR_BUFFER_BIT);
}

class FrameGraphTest : public GpuTest {
 protected:
    /// The passes of these tests look at no frame.
    void execute(FrameGraph& graph, glm::ivec2 size = {8, 4}, bool cut = false) {
        alignas(std::max_align_t) static std::byte none[1];
        graph.execute(*reinterpret_cast<Frame*>(none), size, cut);
    }
    static float red(const FrameGraph& graph, std::string_view target) { return graph.target(target)->read().at(0).x; }
};

TEST_F(FrameGraphTest, RunsPassesAndClearsTargets) {
    glm::ivec2 seen{0};
    TestPass make(
        "make", [](PassDeclaration& d) { d.writes("x", {.format = gpu::Format::r32f, .clear = glm::vec4(3.0f)}, ""); },
        [](PassContext&) {});
    TestPass show(
        "show", [](PassDeclaration& d) { d.reads("x", "").writes("display", {.format = gpu::Format::rgba16f}, ""); },
        [&](PassContext& context) {
            seen = context.size();
            fill(context, glm::vec4(context.texture("x").read().at(0).x + 1.0f));
        });
    FrameGraph graph;
    graph.set_passes({&show, &make});
    execute(graph);
    EXPECT_EQ(seen, glm::ivec2(8, 4));
    EXPECT_EQ(red(graph, "display"), 4.0f);
    EXPECT_EQ(graph.target("display")->desc().width, 8);
    EXPECT_EQ(graph.memory(), 8u * 4u * (4u + 8u));
    EXPECT_THAT(graph.order(), ElementsAre("make", "show"));
    EXPECT_THAT(graph.dot(), HasSubstr("rgba16f 8 x 4"));
}

TEST_F(FrameGraphTest, ClearsDepthIntegersLayersAndMips) {
    TestPass make(
        "make",
        [](PassDeclaration& d) {
            d.keep();
            d.writes("depth", {.format = gpu::Format::depth32f, .clear = glm::vec4(0.25f)}, "");
            d.writes("ids", {.format = gpu::Format::r32ui, .clear = glm::vec4(7.0f)}, "");
            d.writes("layers",
                     {.format = gpu::Format::r16f,
                      .shape = gpu::Shape::array,
                      .layers = 3,
                      .mips = 2,
                      .clear = glm::vec4(0.5f)},
                     "");
        },
        [](PassContext&) {});
    FrameGraph graph;
    graph.retain({"depth", "ids", "layers"});
    graph.set_passes({&make});
    execute(graph);
    EXPECT_EQ(red(graph, "depth"), 0.25f);
    EXPECT_EQ(red(graph, "ids"), 7.0f);
    for (int layer = 0; layer < 3; ++layer)
        for (int mip = 0; mip < 2; ++mip) EXPECT_EQ(graph.target("layers")->read(mip, layer).at(0).x, 0.5f);
}

TEST_F(FrameGraphTest, BindsOneLayerOfOneMip) {
    const std::array<std::string_view, 1> kTargets{"layers"};
    TestPass make(
        "make",
        [](PassDeclaration& d) {
            d.keep().writes("layers",
                            {.format = gpu::Format::r16f,
                             .shape = gpu::Shape::array,
                             .layers = 2,
                             .mips = 2,
                             .clear = glm::vec4(0.0f)},
                            "");
        },
        [&](PassContext& context) {
            context.bind_targets(kTargets, 1, 1);
            glClearColor(1.0f, 1.0f, 1.0f, 1.0f);
            glClear(GL_COLOR_BUFFER_BIT);
        });
    FrameGraph graph;
    graph.retain({"layers"});
    graph.set_passes({&make});
    execute(graph);
    EXPECT_EQ(graph.target("layers")->read(1, 1).at(0).x, 1.0f);
    EXPECT_EQ(graph.target("layers")->read(0, 1).at(0).x, 0.0f);
    EXPECT_EQ(graph.target("layers")->read(1, 0).at(0).x, 0.0f);
}

/// Writes a counter and keeps what it saw of the last frame's.
struct Counter {
    float now = 0.0f;
    std::optional<float> previous;
    TestPass pass{"count",
                  [](PassDeclaration& d) {
                      d.keep().reads("n@previous", "").writes("n", {.format = gpu::Format::r32f, .history = true}, "");
                  },
                  [this](PassContext& context) {
                      const gpu::Texture* last = context.find_texture("n@previous");
                      previous = last ? std::optional(last->read().at(0).x) : std::nullopt;
                      fill(context, glm::vec4(++now));
                  }};
};

TEST_F(FrameGraphTest, HistoryIsTheLastFrame) {
    Counter counter;
    FrameGraph graph;
    graph.set_passes({&counter.pass});
    execute(graph);
    EXPECT_EQ(counter.previous, std::nullopt);
    execute(graph);
    EXPECT_EQ(counter.previous, 1.0f);
    execute(graph);
    EXPECT_EQ(counter.previous, 2.0f);
    EXPECT_EQ(red(graph, "n"), 3.0f);
}

TEST_F(FrameGraphTest, HistoryIsDroppedOnCutAndResizeButNotOnRebuild) {
    Counter counter;
    FrameGraph graph;
    graph.set_passes({&counter.pass});
    execute(graph);
    execute(graph, {8, 4}, true);
    EXPECT_EQ(counter.previous, std::nullopt);
    execute(graph);
    EXPECT_EQ(counter.previous, 2.0f);
    graph.invalidate();
    execute(graph);
    EXPECT_EQ(counter.previous, 3.0f);
    execute(graph, {16, 4});
    EXPECT_EQ(counter.previous, std::nullopt);
}

TEST_F(FrameGraphTest, TransientsShareTexturesAndRetainedOnesDoNot) {
    std::vector<std::unique_ptr<TestPass>> chain;
    std::vector<Pass*> passes;
    for (int i = 0; i < 5; ++i) {
        const std::string to = i == 4 ? "display" : "t" + std::to_string(i);
        const std::string from = "t" + std::to_string(i - 1);
        chain.push_back(std::make_unique<TestPass>(
            "p" + std::to_string(i),
            [=](PassDeclaration& d) {
                if (i > 0) d.reads(from, "");
                d.writes(to, {.format = gpu::Format::r32f}, "");
            },
            [=](PassContext& context) {
                const float before = i > 0 ? context.texture(from).read().at(0).x : 0.0f;
                fill(context, glm::vec4(before + 1.0f));
            }));
        passes.push_back(chain.back().get());
    }
    FrameGraph graph;
    graph.set_passes(passes);
    execute(graph);
    EXPECT_EQ(red(graph, "display"), 5.0f);
    EXPECT_EQ(graph.memory(), 2u * 8u * 4u * 4u);
    EXPECT_EQ(graph.target("t0"), nullptr);
    graph.retain({"t0"});
    execute(graph);
    EXPECT_EQ(red(graph, "t0"), 1.0f);
    EXPECT_EQ(red(graph, "display"), 5.0f);
}

TEST_F(FrameGraphTest, AFailedBuildKeepsTheLastGoodPlan) {
    int runs = 0;
    TestPass good(
        "good", [](PassDeclaration& d) { d.writes("display", {}, ""); }, [&](PassContext&) { ++runs; });
    TestPass bad(
        "bad", [](PassDeclaration& d) { d.reads("displax", "").keep(); }, [](PassContext&) { FAIL(); });
    FrameGraph graph;
    graph.set_passes({&good});
    execute(graph);
    graph.set_passes({&good, &bad});
    EXPECT_THROW(execute(graph), Error);
    execute(graph);
    EXPECT_EQ(runs, 2);
    EXPECT_THAT(graph.order(), ElementsAre("good"));
    graph.set_passes({&bad});  // the good one may be gone: its plan must not run
    EXPECT_THROW(execute(graph), Error);
    EXPECT_THROW(execute(graph), Error);
    EXPECT_EQ(runs, 2);
    graph.set_passes({&good});
    execute(graph);
    EXPECT_EQ(runs, 3);
}

TEST_F(FrameGraphTest, PassesStartFromTheSameState) {
    TestPass rude(
        "rude", [](PassDeclaration& d) { d.writes("display", {.format = gpu::Format::r32f}, ""); },
        [](PassContext& context) {
            fill(context, glm::vec4(1.0f));
            glEnable(GL_SCISSOR_TEST);
            glScissor(0, 0, 1, 1);
            glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        });
    TestPass next(
        "next", [](PassDeclaration& d) { d.updates("display", ""); },
        [](PassContext& context) { fill(context, glm::vec4(2.0f)); });
    FrameGraph graph;
    graph.set_passes({&rude, &next});
    execute(graph);
    EXPECT_EQ(graph.target("display")->read().at(9).x, 2.0f);
}

TEST_F(FrameGraphTest, AbsentOptionalReadsAreNullAndUndeclaredOnesThrow) {
    bool ran = false;
    TestPass pass(
        "pass", [](PassDeclaration& d) { d.reads("fog", "", true).writes("display", {}, ""); },
        [&](PassContext& context) {
            ran = true;
            EXPECT_EQ(context.find_texture("fog"), nullptr);
            EXPECT_THROW(static_cast<void>(context.texture("fog")), Error);
            EXPECT_THROW(static_cast<void>(context.texture("mist")), Error);
        });
    FrameGraph graph;
    graph.set_passes({&pass});
    execute(graph);
    EXPECT_TRUE(ran);
}

TEST_F(FrameGraphTest, TimesEachPass) {
    TestPass pass(
        "pass", [](PassDeclaration& d) { d.writes("display", {}, ""); },
        [](PassContext& context) { fill(context, glm::vec4(1.0f)); });
    FrameGraph graph;
    graph.set_passes({&pass});
    graph.set_timing(true);
    for (int i = 0; i < 8; ++i) execute(graph);
    glFinish();
    execute(graph);
    const std::vector<PassTime> times = graph.times();
    ASSERT_EQ(times.size(), 1u);
    EXPECT_EQ(times[0].name, "pass");
    EXPECT_GE(times[0].milliseconds, 0.0);
}

}  // namespace
}  // namespace tyndall
