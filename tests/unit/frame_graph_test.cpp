#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>
#include <random>

#include "core/error.h"
#include "render/graph_plan.h"

namespace tyndall {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A list of declared passes, built a line each.
class Declared {
 public:
    PassDeclaration& pass(std::string name, Stage stage = Stage::post) {
        passes_.push_back({std::move(name), {}});
        return passes_.back().declaration.stage(stage);
    }
    [[nodiscard]] GraphPlan plan(const std::vector<std::string>& retained = {}) const {
        const std::vector<DeclaredPass> passes(passes_.begin(), passes_.end());
        return plan_graph(passes, retained);
    }
    [[nodiscard]] std::vector<std::string> order(const std::vector<std::string>& retained = {}) const {
        std::vector<std::string> names;
        for (const size_t index : plan(retained).order) names.push_back(passes_[index].name);
        return names;
    }
    [[nodiscard]] std::string error() const {
        try {
            static_cast<void>(plan());
        } catch (const Error& error) {
            return error.what();
        }
        return "no error";
    }

 private:
    std::deque<DeclaredPass> passes_;  // stays in place while passes are added
};

TEST(GraphOrder, CreatorThenUpdatersByStageThenReaders) {
    Declared graph;
    graph.pass("show", Stage::display).reads("radiance", "").writes("display", {}, "");
    graph.pass("fog", Stage::media).updates("radiance", "");
    graph.pass("sky", Stage::sky).updates("radiance", "");
    graph.pass("compose", Stage::compose).reads("albedo", "").writes("radiance", {}, "");
    graph.pass("geometry", Stage::geometry).writes("albedo", {}, "");
    EXPECT_THAT(graph.order(), ElementsAre("geometry", "compose", "sky", "fog", "show"));
}

TEST(GraphOrder, UpdatersThatReadAreUpdaters) {
    Declared graph;
    graph.pass("a").writes("x", {}, "");
    graph.pass("c", Stage::media).updates("x", "").reads("x", "");
    graph.pass("b", Stage::sky).updates("x", "").reads("x", "");
    graph.pass("show", Stage::display).reads("x", "").writes("display", {}, "");
    EXPECT_THAT(graph.order(), ElementsAre("a", "b", "c", "show"));
}

TEST(GraphOrder, ReadyPassesRunByStageThenRegistration) {
    Declared graph;
    graph.pass("late", Stage::media).keep();
    graph.pass("second", Stage::geometry).keep();
    graph.pass("third", Stage::geometry).keep();
    graph.pass("first", Stage::shadow).keep();
    EXPECT_THAT(graph.order(), ElementsAre("first", "second", "third", "late"));
}

TEST(GraphOrder, AfterOrdersUpdatersOfOneStage) {
    Declared graph;
    graph.pass("make").writes("display", {}, "");
    graph.pass("b", Stage::post).updates("display", "").after("a");
    graph.pass("a", Stage::post).updates("display", "");
    EXPECT_THAT(graph.order(), ElementsAre("make", "a", "b"));
}

TEST(GraphOrder, DataOrdersUpdatersOfOneStage) {
    Declared graph;
    graph.pass("make").writes("display", {}, "");
    graph.pass("b", Stage::post).updates("display", "").reads("mask", "");
    graph.pass("a", Stage::post).updates("display", "").writes("mask", {}, "");
    EXPECT_THAT(graph.order(), ElementsAre("make", "a", "b"));
}

TEST(GraphOrder, AfterAnAbsentPassMeansNothing) {
    Declared graph;
    graph.pass("a").writes("display", {}, "").after("some_module.pass");
    EXPECT_THAT(graph.order(), ElementsAre("a"));
}

TEST(GraphOrder, PreviousFrameOrdersNothing) {
    Declared graph;
    graph.pass("blend").reads("history@previous", "").reads("now", "").writes("history", {.history = true}, "");
    graph.pass("now").writes("now", {}, "");
    graph.pass("show", Stage::display).reads("history", "").writes("display", {}, "");
    EXPECT_THAT(graph.order(), ElementsAre("now", "blend", "show"));
    EXPECT_TRUE(graph.plan().targets[0].history);
}

TEST(GraphCulling, LeavesOutWhatNothingNeeds) {
    Declared graph;
    graph.pass("show", Stage::display).reads("radiance", "").writes("display", {}, "");
    graph.pass("light").writes("radiance", {}, "").writes("luminance", {}, "");
    graph.pass("histogram").updates("luminance", "").reads("weights", "");
    graph.pass("weights").writes("weights", {}, "");
    EXPECT_THAT(graph.order(), ElementsAre("light", "show"));
    EXPECT_THAT(graph.order({"luminance"}), ElementsAre("light", "weights", "histogram", "show"));
    EXPECT_THAT(graph.order({"no_such_target"}), ElementsAre("light", "show"));
}

TEST(GraphCulling, KeepNeedsItsInputs) {
    Declared graph;
    graph.pass("probe").reads("depth", "").keep();
    graph.pass("geometry", Stage::geometry).writes("depth", {}, "");
    EXPECT_THAT(graph.order(), ElementsAre("geometry", "probe"));
}

TEST(GraphCulling, HistoryNeedsItsWriter) {
    Declared graph;
    graph.pass("show", Stage::display).reads("exposure@previous", "").writes("display", {}, "");
    graph.pass("meter").writes("exposure", {.history = true}, "");
    EXPECT_THAT(graph.order(), testing::UnorderedElementsAre("meter", "show"));
}

TEST(GraphErrors, UnknownReadNamesPassAndNearestTarget) {
    Declared graph;
    graph.pass("fog.march").reads("scene_deph", "").keep();
    graph.pass("geometry").writes("scene_depth", {}, "");
    EXPECT_THAT(graph.error(),
                HasSubstr("pass 'fog.march' reads 'scene_deph', which no pass writes (did you mean 'scene_depth'?)"));
}

TEST(GraphErrors, OptionalReadMayBeMissing) {
    Declared graph;
    graph.pass("show").reads("fog", "", true).reads("fog@previous", "", true).writes("display", {}, "");
    EXPECT_THAT(graph.order(), ElementsAre("show"));
}

TEST(GraphErrors, AllAtOnce) {
    Declared graph;
    graph.pass("a").writes("x", {}, "").reads("x", "");
    graph.pass("a").writes("x", {}, "").updates("y", "");
    graph.pass("b").writes("z@previous", {}, "").writes("w", {.scale = 0.0f}, "");
    graph.pass("c").reads("x@previous", "");
    const std::string text = graph.error();
    EXPECT_THAT(text, HasSubstr("two passes are called 'a'"));
    EXPECT_THAT(text, HasSubstr("pass 'a' reads 'x', which it writes itself"));
    EXPECT_THAT(text, HasSubstr("passes 'a' and 'a' both create target 'x'"));
    EXPECT_THAT(text, HasSubstr("pass 'a' updates 'y', which no pass writes"));
    EXPECT_THAT(text, HasSubstr("'z@previous'"));
    EXPECT_THAT(text, HasSubstr("scale 0"));
    EXPECT_THAT(text, HasSubstr("pass 'c' reads 'x@previous', but 'a' writes that target without history"));
}

TEST(GraphErrors, WriteAndUpdate) {
    Declared graph;
    graph.pass("a").writes("x", {}, "").updates("x", "");
    EXPECT_THAT(graph.error(), HasSubstr("pass 'a' both writes and updates 'x'"));
}

TEST(GraphErrors, UpdatersWithoutOrder) {
    Declared graph;
    graph.pass("make").writes("display", {}, "");
    graph.pass("fog.apply", Stage::media).updates("display", "");
    graph.pass("clouds.apply", Stage::media).updates("display", "").after("fog.aply");
    EXPECT_THAT(graph.error(),
                HasSubstr("passes 'fog.apply' and 'clouds.apply' both update 'display' in stage media without order"));
    EXPECT_THAT(graph.error(), HasSubstr("did you mean 'fog.apply'?"));
}

TEST(GraphErrors, CycleNamesItsPassesOnly) {
    Declared graph;
    graph.pass("innocent").writes("start", {}, "");
    graph.pass("a").reads("start", "").reads("z", "").writes("x", {}, "");
    graph.pass("b").reads("x", "").writes("y", {}, "");
    graph.pass("c").reads("y", "").writes("z", {}, "");
    graph.pass("victim").reads("z", "").writes("display", {}, "");
    const std::string text = graph.error();
    EXPECT_THAT(text, HasSubstr("'a' waits for 'c' (z)"));
    EXPECT_THAT(text, HasSubstr("'b' waits for 'a' (x)"));
    EXPECT_THAT(text, HasSubstr("'c' waits for 'b' (y)"));
    EXPECT_THAT(text, testing::Not(HasSubstr("innocent")));
    EXPECT_THAT(text, testing::Not(HasSubstr("victim")));
}

TEST(GraphLifetimes, EndWithTheLastReaderOrTheFrame) {
    Declared graph;
    graph.pass("a").writes("x", {}, "").writes("unused", {}, "");
    graph.pass("b").reads("x", "").writes("y", {}, "");
    graph.pass("c").reads("y", "").writes("display", {}, "");
    const GraphPlan plan = graph.plan();
    EXPECT_EQ(plan.targets[0].last, 1);
    EXPECT_EQ(plan.targets[1].last, 0);
    EXPECT_EQ(plan.targets[2].first, 1);
    EXPECT_TRUE(plan.targets[3].whole_frame);
    EXPECT_EQ(plan.targets[3].last, 3);
    EXPECT_EQ(graph.plan({"x"}).targets[0].last, 3);
}

TEST(GraphSharing, TexturesNeverServeTwoTargetsAtOnce) {
    std::mt19937 random(7);
    const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    for (int round = 0; round < 500; ++round) {
        std::vector<Lifetime> lives(static_cast<size_t>(1 + pick(30)));
        for (Lifetime& life : lives) {
            life.desc.width = 1 + pick(3);
            life.first = pick(20);
            life.last = life.first + pick(8);
        }
        const std::vector<size_t> textures = share_textures(lives);
        for (size_t i = 0; i < lives.size(); ++i)
            for (size_t j = 0; j < i; ++j) {
                if (textures[i] != textures[j]) continue;
                EXPECT_EQ(lives[i].desc, lives[j].desc);
                EXPECT_TRUE(lives[i].last < lives[j].first || lives[j].last < lives[i].first);
            }
    }
}

TEST(GraphSharing, ReusesAsSoonAsItMay) {
    const std::vector<Lifetime> chain{{{}, 0, 1}, {{}, 1, 2}, {{}, 2, 3}, {{}, 3, 4}};
    EXPECT_THAT(share_textures(chain), ElementsAre(0u, 1u, 0u, 1u));
}

TEST(GraphTextureDesc, ScalesRoundUpAndMipsEnd) {
    const gpu::TextureDesc half = texture_desc({.scale = 0.5f, .mips = 0}, {641, 3});
    EXPECT_EQ(half.width, 321);
    EXPECT_EQ(half.height, 2);
    EXPECT_EQ(half.mips, 9);
    const gpu::TextureDesc fixed = texture_desc({.size = {64, 32}, .layers = 4}, {641, 3});
    EXPECT_EQ(fixed.width, 64);
    EXPECT_EQ(texture_bytes(fixed), 64u * 32u * 4u * 8u);
}

TEST(GraphText, NamesPassesAndTargets) {
    std::vector<DeclaredPass> passes{{"geometry", {}}, {"show", {}}};
    passes[0].declaration.writes("albedo", {}, "");
    passes[1].declaration.reads("albedo", "").writes("display", {}, "");
    const std::vector<size_t> textures{0, 1};
    const std::string text = graph_text(passes, plan_graph(passes, {}), textures, {640, 360});
    EXPECT_THAT(text, HasSubstr("\"geometry\" -> \"t:albedo\""));
    EXPECT_THAT(text, HasSubstr("\"t:albedo\" -> \"show\""));
    EXPECT_THAT(text, HasSubstr("640 x 360"));
}

}  // namespace
}  // namespace tyndall
