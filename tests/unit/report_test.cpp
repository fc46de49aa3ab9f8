#include "report/report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "core/error.h"
#include "core/paths.h"
#include "report/history.h"
#include "report/pixels.h"
#include "temporary_folder.h"

namespace tyndall::report {
namespace {

Image gradient(int width, int height, float scale) {
    Image image(width, height, 3, Image::Type::f32);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c) image.at(x, y, c) = scale * static_cast<float>(1 + x + 2 * y + 3 * c);
    return image;
}

Entry entry_called(const std::string& name) {
    Entry entry;
    entry.name = name;
    entry.reference = gradient(32, 16, 1);
    entry.test = gradient(32, 16, 1.1f);
    entry.metrics = {{"relmse", 0.01}};
    return entry;
}

class ReportFolder : public TemporaryFolder {};

TEST(Base64, FollowsTheStandardsExamples) {
    // RFC 4648, section 10.
    const auto encoded = [](std::string_view text) { return base64(std::as_bytes(std::span(text))); };
    EXPECT_EQ(encoded(""), "");
    EXPECT_EQ(encoded("f"), "Zg==");
    EXPECT_EQ(encoded("fo"), "Zm8=");
    EXPECT_EQ(encoded("foo"), "Zm9v");
    EXPECT_EQ(encoded("foobar"), "Zm9vYmFy");
}

TEST_F(ReportFolder, IsOneFolderThatNeedsNothingElse) {
    Report report;
    report.title = "Fog & </script> <b>";
    report.entries = {entry_called("a </script> b"), entry_called("second/with: odd \"characters\"")};
    report.sections = {{"Pareto", "<svg width='10' height='10'></svg>"}};
    write_report(folder_, report);
    const std::string page = paths::read_file(folder_ / "index.html");
    EXPECT_EQ(page.find("{{"), std::string::npos);
    EXPECT_EQ(page.find("</script> b"), std::string::npos) << "a name ends the script";
    for (const char* from_outside : {"http://", "https://", "src=\"/", "@import"}) {
        const size_t at = page.find(from_outside);
        // The name of SVG's namespace is no address that is opened.
        EXPECT_TRUE(at == std::string::npos || page.compare(at, 26, "http://www.w3.org/2000/svg") == 0) << from_outside;
    }
    size_t files = 0;
    for (const auto& file : std::filesystem::directory_iterator(folder_ / "data")) files += file.is_regular_file();
    EXPECT_EQ(files, 2u * 4);
}

TEST_F(ReportFolder, KeepsPastRuns) {
    Report report;
    report.entries = {entry_called("fog")};
    for (const double value : {0.3, 0.2, std::numeric_limits<double>::infinity()}) {
        report.entries[0].metrics["relmse"] = value;
        write_report(folder_, report);
    }
    const auto history = load_history(folder_ / "history.jsonl");
    ASSERT_EQ(history.at("fog").size(), 3u);
    EXPECT_EQ(history.at("fog")[0].metrics.at("relmse"), 0.3);
    EXPECT_EQ(history.at("fog")[1].metrics.at("relmse"), 0.2);
    EXPECT_TRUE(std::isnan(history.at("fog")[2].metrics.at("relmse")));
}

TEST_F(ReportFolder, ABrokenHistoryKeepsItsWholeLines) {
    const std::filesystem::path file = folder_ / "history.jsonl";
    append_history(file, {entry_called("fog")}, {"2026-01-01T00:00:00Z"});
    std::ofstream(file, std::ios::app) << "{\"time\": \"2026-01-02T0";  // killed while writing
    append_history(file, {entry_called("fog")}, {"2026-01-03T00:00:00Z"});
    const auto history = load_history(file);
    ASSERT_EQ(history.at("fog").size(), 2u);
    EXPECT_EQ(history.at("fog")[1].time, "2026-01-03T00:00:00Z");
}

TEST_F(ReportFolder, RefusesWhatItCannotShow) {
    Report report;
    report.entries = {entry_called("fog"), entry_called("fog")};
    EXPECT_THROW(write_report(folder_, report), Error);
    report.entries = {entry_called("fog")};
    report.entries[0].test = gradient(16, 16, 1);
    EXPECT_THROW(write_report(folder_, report), Error);
    report.entries = {entry_called("fog")};
    std::ofstream(folder_ / "taken") << "a file";
    EXPECT_THROW(write_report(folder_ / "taken", report), Error);
}

TEST(Report, ExposureIsThatOfTheBrightPart) {
    Entry entry = entry_called("fog");
    for (float& v : entry.reference.floats()) v = 4;
    EXPECT_NEAR(exposure_of(entry), 0.25, 1e-6);
    entry.exposure = 3;
    EXPECT_EQ(exposure_of(entry), 3);
}

TEST(Report, NotFiniteIsMagenta) {
    Image image = gradient(2, 1, 0.1f);
    image.at(1, 0, 1) = std::numeric_limits<float>::quiet_NaN();
    const Image shown = developed(image, 1);
    EXPECT_EQ(shown.bytes()[3], 255);
    EXPECT_EQ(shown.bytes()[4], 0);
    EXPECT_EQ(shown.bytes()[5], 255);
    EXPECT_NE(shown.bytes()[0], 255);
}

}  // namespace
}  // namespace tyndall::report
