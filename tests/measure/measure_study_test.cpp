#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "../unit/temporary_folder.h"
#include "core/error.h"
#include "core/paths.h"
#include "measure/noise_floor.h"
#include "measure/results.h"
#include "measure/study.h"

namespace tyndall::measure {
namespace {

constexpr const char* kStudy = R"({
  "tyndall_study": 1, "title": "A test",
  "scenes": [ { "name": "one", "scene": "scene.json", "set": ["/a=1"] }, { "name": "two", "scene": "scene.json" } ],
  "techniques": [
    { "name": "march", "set": ["/b=2"], "sweep": [ { "set": "/render/steps", "values": [2, 4.5] },
                                                   { "name": "resolution", "set": "/render/r", "texts": ["full", "half"] } ] },
    { "name": "chosen", "scenes": ["two"], "points": [ { "name": "fast", "set": ["/c=3"] }, { "name": "fine" } ] },
    { "name": "none", "set": ["/off=true"] } ],
  "baseline": "none" })";

class StudyFile : public TemporaryFolder {
 protected:
    Study load(const std::string& text) {
        paths::write_file_atomically(folder_ / "scene.json", "{}");
        paths::write_file_atomically(folder_ / "study.json", text);
        return load_study(folder_ / "study.json");
    }
    /// What is said of a study in which one text was replaced by another.
    std::string said(const std::string& what, const std::string& with) {
        std::string text = kStudy;
        const size_t at = text.find(what);
        EXPECT_NE(at, std::string::npos) << what;
        text.replace(at, what.size(), with);
        try {
            (void)load(text);
        } catch (const Error& error) {
            return error.what();
        }
        return "nothing";
    }
};

std::vector<std::string> labels(const std::vector<Run>& runs) {
    std::vector<std::string> all;
    for (const Run& run : runs) all.push_back(run.scene->name + ": " + run.label());
    return all;
}

TEST_F(StudyFile, SweepsGiveEachCombinationTheLastFastest) {
    const Study study = load(kStudy);
    const std::vector<std::string> march{"march, steps 2, resolution full", "march, steps 2, resolution half",
                                         "march, steps 4.5, resolution full", "march, steps 4.5, resolution half"};
    std::vector<std::string> wanted{"one: none"};
    for (const std::string& run : march) wanted.push_back("one: " + run);
    wanted.emplace_back("two: none");
    for (const std::string& run : march) wanted.push_back("two: " + run);
    wanted.insert(wanted.end(), {"two: chosen, fast", "two: chosen, fine"});
    const auto runs = runs_of(study);
    EXPECT_EQ(labels(runs), wanted);
    EXPECT_TRUE(runs[0].baseline);
    EXPECT_FALSE(runs[1].baseline);
    EXPECT_EQ(runs[2].set, (std::vector<std::string>{"/a=1", "/b=2", "/render/steps=2", "/render/r=half"}));
    EXPECT_EQ(runs[10].set, (std::vector<std::string>{"/c=3"}));
}

TEST_F(StudyFile, OnlyTakesScenesAndTechniquesAndKeepsTheBaseline) {
    const Study study = load(kStudy);
    EXPECT_EQ(labels(runs_of(study, {"two", "chosen"})),
              (std::vector<std::string>{"two: none", "two: chosen, fast", "two: chosen, fine"}));
    EXPECT_EQ(runs_of(study, {"one"}).size(), 5u);
    EXPECT_EQ(runs_of(study, {"march"}).size(), 10u);
    try {
        (void)runs_of(study, {"marsh"});
        FAIL() << "an unknown name is taken";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("did you mean 'march'"), std::string::npos) << error.what();
    }
}

TEST_F(StudyFile, SaysWhatIsWrongAndWhere) {
    struct Wrong {
        std::string what, with;
        std::vector<std::string> expected;
    };
    const Wrong all[] = {
        {"\"title\"", "\"titel\"", {"study.json:2:", "/titel", "did you mean 'title'"}},
        {"\"sweep\"", "\"sweeps\"", {"/techniques/0/sweeps", "did you mean 'sweep'"}},
        {"\"tyndall_study\": 1", "\"tyndall_study\": 2", {"/tyndall_study", "out of range"}},
        {"scene.json", "scene_.json", {"/scenes/0/scene", "there is no file"}},
        {"\"two\", \"scene\"", "\"one\", \"scene\"", {"/scenes/1/name", "two are named 'one'"}},
        {"/a=1", "a=1", {"/scenes/0/set/0", "is no assignment"}},
        {"[\"two\"]", "[\"tow\"]", {"/techniques/1/scenes/0", "did you mean 'two'"}},
        {"\"baseline\": \"none\"", "\"baseline\": \"march\"", {"/baseline", "has points, sweeps"}},
        {"\"baseline\": \"none\"", "\"baseline\": \"nine\"", {"/baseline", "did you mean 'none'"}},
        {"\"values\": [2, 4.5]", "\"values\": []", {"/techniques/0/sweep/0", "has no values"}},
        {"\"/render/steps\"", "\"steps\"", {"/techniques/0/sweep/0/set", "no JSON pointer"}},
        {"\"baseline\"", "\"plots\": [\"relmes\"], \"baseline\"", {"/plots/0", "relmse"}},
        {"\"baseline\"", "\"plots\": [\"ssim\"], \"baseline\"", {"/plots/0", "more of 'ssim' is better"}},
        {"\"set\": [\"/a=1\"]", "\"size\": [0.5, 10]", {"/scenes/0/size", "out of range"}},
        {"\"set\": [\"/a=1\"]",
         "\"reference\": { \"min_order\": 2, \"max_order\": 1 }",
         {"/scenes/0/reference/max_order"}},
        {"[2, 4.5]", "[2, 4.5", {"study.json:"}},
    };
    for (const Wrong& wrong : all) {
        const std::string text = said(wrong.what, wrong.with);
        for (const std::string& expected : wrong.expected)
            EXPECT_NE(text.find(expected), std::string::npos) << wrong.with << "\nlacks " << expected << ":\n" << text;
    }
    EXPECT_THROW((void)load_study(folder_ / "nowhere.json"), Error);
}

TEST_F(StudyFile, TooManyRunsAreRefused) {
    std::string values = "1";
    for (int i = 2; i <= 6000; ++i) values += ", " + std::to_string(i);
    const std::string text = said("2, 4.5", values);
    EXPECT_NE(text.find("runs"), std::string::npos) << text;
}

TEST(NoiseFloor, IsTheRelMseThatTheVarianceGives) {
    // One channel value each: mean r = 2, so the denominators are 1 + 0.04, 4 + 0.04 and 9 + 0.04.
    NoisyPicture reference{Image(1, 1, 3, Image::Type::f32), Image(1, 1, 3, Image::Type::f32)};
    for (int c = 0; c < 3; ++c) {
        reference.radiance.at(0, 0, c) = static_cast<float>(c + 1);
        reference.variance.at(0, 0, c) = 0.1f * static_cast<float>(c + 1);
    }
    EXPECT_NEAR(noise_floor(reference), (0.1 / 1.04 + 0.2 / 4.04 + 0.3 / 9.04) / 3, 1e-7);
    reference.variance = {};
    EXPECT_LT(noise_floor(reference), 0);
}

Row row(const std::string& technique, double ms, double relmse) {
    Row made;
    made.scene = "fog";
    made.technique = technique;
    made.label = technique + ", steps 4";
    made.parameters = {{"steps", "4"}};
    made.ms = ms;
    made.processor_ms = 2 * ms;
    made.metrics = {{"relmse", relmse}, {"mean_ratio", 1.001}};
    return made;
}

Results results() {
    Results all;
    all.title = "A test";
    all.baseline = "none";
    all.plots = {"relmse"};
    SceneResults& scene = all.scenes.emplace_back();
    scene.name = "fog";
    scene.noise_floor = 1e-4;
    scene.reference = "traced";
    Row none = row("none", 10, 0);
    none.baseline = true;
    none.metrics.clear();
    Row failed = row("broken", 0, 0);
    failed.metrics.clear();
    failed.problem = "it | broke\nin two lines";
    scene.rows = {none, row("fast", 12, 0.02), row("slow", 20, 1.5e-4), row("worse", 21, 0.01), failed};
    conclude(all);
    return all;
}

TEST(Results, TimesAreAboveTheBaselineAndTheFrontIsMarked) {
    const Results all = results();
    const std::vector<Row>& rows = all.scenes[0].rows;
    EXPECT_FALSE(rows[0].ms_above);
    EXPECT_DOUBLE_EQ(rows[1].ms_above.value(), 2);
    EXPECT_DOUBLE_EQ(rows[1].processor_ms_above.value(), 4);
    EXPECT_TRUE(rows[1].on_front && rows[2].on_front);
    EXPECT_FALSE(rows[0].on_front || rows[3].on_front || rows[4].on_front);
    EXPECT_TRUE(rows[2].within_noise);
    EXPECT_FALSE(rows[1].within_noise);
}

TEST(Results, ARowSurvivesItsJson) {
    Row before = row("fast", 12, 0.02);
    before.least_ms = 11;
    before.target_bytes = 1e6;
    before.notes = {"a note"};
    const Row after = row_from_json(nlohmann::json::parse(to_json(before).dump()));
    EXPECT_EQ(to_json(before), to_json(after));
    EXPECT_THROW((void)row_from_json(nlohmann::json::parse("{}")), std::exception);
}

TEST(Results, TablesHaveEveryRowAndStayTables) {
    const std::string text = markdown_of(results());
    for (const char* part :
         {"| ● fast | steps 4 | 12.0 | 2.0 | 4.0 | 0.02 |", "0.00015 ≈", "it \\| broke; in two lines"})
        EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
    const Results all = results();
    const Table table = table_of(all, all.scenes[0]);
    for (const auto& line : table.lines) EXPECT_EQ(line.size(), table.head.size());
    EXPECT_NE(html_of(table).find("<td>failed: it | broke"), std::string::npos);
}

TEST(Results, PlotsLeaveOutWhatHasNoTimeOrError) {
    const Results all = results();
    const Plot plot = plot_of(all, all.scenes[0], "relmse");
    ASSERT_EQ(plot.series.size(), 3u);
    EXPECT_EQ(plot.series[0].name, "fast");
    EXPECT_DOUBLE_EQ(plot.series[0].points[0].x, 2);
    EXPECT_TRUE(plot.series[1].points[0].within_noise);
    EXPECT_DOUBLE_EQ(plot.noise_floor, 1e-4);
    EXPECT_EQ(plot_of(all, all.scenes[0], "flip").series.size(), 0u);
}

}  // namespace
}  // namespace tyndall::measure
