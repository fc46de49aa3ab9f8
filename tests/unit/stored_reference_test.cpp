#include "app/stored_reference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <random>

#include "app/expectations.h"
#include "app/reference_recipe.h"
#include "core/error.h"
#include "core/paths.h"
#include "image/image_io.h"
#include "temporary_folder.h"

namespace tyndall {
namespace {

constexpr const char* kScene = R"({ "tyndall": 1, "description": "one", "render": { "path": "deferred" },
  "entities": [ { "name": "Eye", "camera": {} }, { "name": "Lamp", "point_light": { "intensity_cd": 100, "gobo": "table.json" } } ] })";

class StoredReference : public TemporaryFolder {
 protected:
    void SetUp() override {
        TemporaryFolder::SetUp();
        write("scene.json", kScene);
        write("table.json", R"({ "file": "table.raw" })");
        write("table.raw", "1234");
        capture_.file = folder_ / "capture.json";
        capture_.scene = "scene.json";
        capture_.size = {48.0f, 32.0f};
        capture_.variants = {{.name = "a"}};
        capture_.references = {{.name = "truth", .samples = 64}};
    }

    void write(const char* name, const std::string& text) { std::ofstream(folder_ / name) << text; }
    [[nodiscard]] std::string recipe() const { return recipe_of(capture_, capture_.references.front()); }
    [[nodiscard]] NoisyPicture load() const { return load_reference(capture_, capture_.references.front()); }
    void store(const NoisyPicture& picture) const {
        save_reference(file_of(capture_, capture_.references.front()), picture, recipe(), 64, 0);
    }
    [[nodiscard]] std::string problem() const {
        try {
            (void)load();
        } catch (const Error& error) {
            return error.what();
        }
        return "none";
    }

    /// A ramp with a sky of one exact colour, and 2 % of noise below it.
    [[nodiscard]] static NoisyPicture noisy(float scale) {
        NoisyPicture picture{Image(48, 32, 3, Image::Type::f32), Image(48, 32, 3, Image::Type::f32)};
        std::mt19937 random(7);
        std::normal_distribution<float> normal;
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 48; ++x)
                for (int c = 0; c < 3; ++c) {
                    const float mean = scale * (y < 8 ? 0.3f : 0.01f * static_cast<float>(x + c + 1));
                    const float deviation = y < 8 ? 0.0f : 0.02f * mean;
                    picture.radiance.at(x, y, c) = mean + deviation * normal(random);
                    picture.variance.at(x, y, c) = deviation * deviation;
                }
        return picture;
    }

    CaptureFile capture_;
};

TEST_F(StoredReference, RecipeIsOfWhatIsTraced) {
    const std::string before = recipe();
    write("scene.json", R"({"tyndall":1,"description":"other words","render":{"path":"light_pre_pass"},"entities":[
        {"camera":{},"name":"Eye"},{"point_light":{"gobo":"table.json","intensity_cd":100},"name":"Lamp"}]})");
    EXPECT_EQ(difference_of_recipes(before, recipe()), "") << "spaces, order, words and how it is rendered";
    capture_.variants.front().set = {"/entities/Lamp/point_light/intensity_cd=101"};
    EXPECT_NE(difference_of_recipes(before, recipe()).find("scene changed"), std::string::npos);
    capture_.variants.front().set = {"/render/camera=\"Eye\""};
    EXPECT_NE(difference_of_recipes(before, recipe()).find(R"(camera was "", is "Eye")"), std::string::npos);
    capture_.variants.front().set.clear();
    write("table.raw", "1235");
    EXPECT_NE(difference_of_recipes(before, recipe()).find("files changed"), std::string::npos)
        << "a file that a file names";
    write("table.raw", "1234");
    EXPECT_EQ(difference_of_recipes(before, recipe()), "");
    capture_.references.front().single_scattering = true;
    EXPECT_NE(difference_of_recipes(before, recipe()).find("orders was [0,-1], is [0,1]"), std::string::npos);
}

TEST_F(StoredReference, KeepsWhatItsNoiseLeavesWorthKeeping) {
    for (const float scale : {1.0f, 1e7f, 1e-5f}) {
        const NoisyPicture picture = noisy(scale);
        store(picture);
        const NoisyPicture kept = load();
        const ZTest z = z_test(picture, {kept.radiance, kept.variance});
        double most = 0.0, sum = 0.0, kept_sum = 0.0;
        for (size_t i = 0; i < picture.radiance.value_count(); ++i) {
            const auto was = static_cast<double>(picture.radiance.floats()[i]),
                       is = static_cast<double>(kept.radiance.floats()[i]);
            const double step =
                std::max(std::sqrt(static_cast<double>(picture.variance.floats()[i])) / 2, std::abs(was) / 1024);
            most = std::max(most, std::abs(is - was) / step);
            sum += was;
            kept_sum += is;
            EXPECT_GE(kept.variance.floats()[i], 0.95f * picture.variance.floats()[i]);
        }
        const auto bytes = std::filesystem::file_size(file_of(capture_, capture_.references.front()));
        std::printf("scale %g: %zu bytes of %zu, mean off by %.2g, at most %.2f steps, Z-test p %.3g\n",
                    static_cast<double>(scale), static_cast<size_t>(bytes), picture.radiance.value_count() * 8,
                    std::abs(kept_sum / sum - 1), most, z.p);
        EXPECT_LE(most, 1.001);
        EXPECT_LT(std::abs(kept_sum / sum - 1), 2e-4);
        EXPECT_GT(z.p, 0.01) << "also where there was no noise: the sky";
        EXPECT_LT(bytes, picture.radiance.value_count() * 4);
    }
}

TEST_F(StoredReference, SaysWhatIsWrongWithAFile) {
    EXPECT_NE(problem().find("truth.exr: the reference 'truth' is not there (expected run tyndall capture --retrace"),
              std::string::npos)
        << problem();
    store(noisy(1));
    EXPECT_EQ(problem(), "none");
    capture_.references.front().samples = 128;
    EXPECT_NE(problem().find("another recipe: samples was 64, is 128"), std::string::npos) << problem();
    EXPECT_NE(problem().find("tyndall capture --retrace"), std::string::npos) << problem();
    capture_.references.front().samples = 64;

    const std::filesystem::path file = file_of(capture_, capture_.references.front());
    const std::string whole = paths::read_file(file);
    std::ofstream(file, std::ios::binary) << whole.substr(0, whole.size() / 2);
    EXPECT_NE(problem().find("truth.exr"), std::string::npos) << problem();
    std::ofstream(file, std::ios::binary) << "no picture";
    EXPECT_NE(problem().find("not a picture"), std::string::npos) << problem();

    Image broken(48, 32, 6, Image::Type::f32);
    ExrOptions options{.channel_names = {"R", "G", "B", "variance.R", "variance.G", "variance.B"}};
    save_exr(file, broken, options);
    EXPECT_NE(problem().find("no recipe"), std::string::npos) << problem();
    options.metadata = {{"tyndall.recipe", recipe()}};
    broken.at(5, 3, 1) = std::numeric_limits<float>::quiet_NaN();
    save_exr(file, broken, options);
    EXPECT_NE(problem().find("the radiance is nan at x 5, y 3"), std::string::npos) << problem();
    broken.at(5, 3, 1) = 0;
    broken.at(6, 3, 4) = -1;
    save_exr(file, broken, options);
    EXPECT_NE(problem().find("the variance is -1 at x 6, y 3"), std::string::npos) << problem();
    save_exr(file, Image(24, 16, 6, Image::Type::f32), options);
    EXPECT_NE(problem().find("24x16"), std::string::npos) << problem();
    EXPECT_THROW(store({noisy(1).radiance, Image()}), Error) << "a variance is needed";
}

TEST_F(StoredReference, Judges) {
    const NoisyPicture truth = noisy(1);
    store(truth);
    CapturedPicture same{truth.radiance, Image(48, 32, 3, Image::Type::u8)}, brighter = same;
    for (float& value : brighter.radiance.floats()) value *= 1.01f;
    capture_.expect = {{.of = "a", .traced = "truth", .max_relmse = 1e-3f, .min_z_p = 0.01f}};
    const Verdict held = judge(capture_, {{"a", same}}).front(), off = judge(capture_, {{"a", brighter}}).front();
    EXPECT_EQ(held.outcome, Verdict::Outcome::held) << held.text;
    ASSERT_EQ(held.compared.size(), 1u);
    EXPECT_EQ(held.compared.front().backing, Backing::truth);
    EXPECT_EQ(off.outcome, Verdict::Outcome::failed) << off.text;
    EXPECT_NE(off.text.find("Z-test p"), std::string::npos) << off.text;
    EXPECT_EQ(judge(capture_, {{"a", same}}, "Other").front().outcome, Verdict::Outcome::skipped)
        << "another camera's view";

    save_exr(folder_ / "old.exr", truth.radiance);
    capture_.expect = {{.of = "a", .reference = "old.exr", .baseline = true, .max_relmse = 0.0f}};
    const Verdict baseline = judge(capture_, {{"a", same}}).front();
    EXPECT_EQ(baseline.outcome, Verdict::Outcome::held) << baseline.text;
    EXPECT_EQ(baseline.compared.at(0).backing, Backing::baseline);
    EXPECT_NE(baseline.text.find("a baseline, no truth backs it"), std::string::npos) << baseline.text;

    capture_.references.front().samples = 65;
    capture_.expect = {{.of = "a", .traced = "truth", .max_relmse = 1.0f}};
    const Verdict old = judge(capture_, {{"a", same}}).front();
    EXPECT_EQ(old.outcome, Verdict::Outcome::failed);
    EXPECT_NE(old.text.find("--retrace"), std::string::npos) << old.text;
}

std::string problems_of(const std::filesystem::path& folder, const std::string& rest) {
    std::ofstream(folder / "c.json") << R"({"tyndall_capture": 1, "scene": "s.json", "variants": [{"name": "a"}], )" +
                                            rest + "}";
    try {
        (void)load_capture(folder / "c.json");
    } catch (const Error& error) {
        return error.what();
    }
    return "none";
}

TEST_F(StoredReference, CaptureFilesAreChecked) {
    const auto says = [&](const std::string& rest, const std::string& words) {
        const std::string said = problems_of(folder_, rest);
        EXPECT_NE(said.find(words), std::string::npos) << rest << "\n" << said;
    };
    says(R"("references": [{"name": "t"}], "expect": [{"of": "a", "traced": "t", "max_relmse": 1}])", "none");
    says(R"("references": [{"name": "truth"}], "expect": [{"of": "a", "traced": "trut", "max_relmse": 1}])",
         "/expect/0: unknown reference 'trut' (expected a name from /references; did you mean 'truth'?)");
    says(R"("references": [{"name": "../t"}])", "/references/0/name");
    says(R"("references": [{"name": "t"}, {"name": "t"}])", "two references are named 't'");
    says(R"("references": [{"name": "t", "variant": "b"}])", "unknown variant 'b'");
    says(R"("references": [{"name": "t", "orders": [2, 1]}])", "/references/0/orders");
    says(R"("references": [{"name": "t", "size": [10, 0]}])", "/references/0/size");
    says(R"("references": [{"name": "t", "orders": [0, 1], "single_scattering": true}])",
         "both orders and single_scattering");
    says(R"("cameras": ["A", "B"], "references": [{"name": "t"}])", "which of the capture's cameras");
    says(R"("expect": [{"of": "a", "reference": "old.exr", "max_relmse": 1}])",
         "/expect/0: no truth backs the picture 'old.exr'");
    says(R"("expect": [{"of": "a", "reference": "old.exr", "baseline": true, "max_relmse": 1}])", "none");
    says(R"("expect": [{"of": "a", "baseline": true}])", "/expect/0/baseline");
    says(R"("expect": [{"of": "a", "max_relmse": 1}])", "nothing that the picture is held against");
    says(R"("expect": [{"of": "a", "equals": "a", "min_z_p": 0.01}])", "/expect/0/min_z_p");
}

}  // namespace
}  // namespace tyndall
