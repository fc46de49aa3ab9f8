// Volumes from files: what is read, and what is said of files that cannot be read.

#include "image/volume.h"

#include <openvdb/openvdb.h>

#include <cmath>
#include <fstream>
#include <random>

#include "core/error.h"
#include "core/paths.h"
#include "temporary_folder.h"

namespace tyndall {
namespace {

namespace fs = std::filesystem;

class Volumes : public TemporaryFolder {
 protected:
    void SetUp() override {
        TemporaryFolder::SetUp();
        openvdb::initialize();
    }
    fs::path write(const std::string& name, std::string_view content) {
        std::ofstream(folder_ / name, std::ios::binary) << content;
        return folder_ / name;
    }
    fs::path write_vdb(const std::string& name, const openvdb::GridPtrVec& grids) {
        openvdb::io::File(folder_ / name).write(grids);
        return folder_ / name;
    }
    /// A ball of radius 6 around (100, -3, 7), 1 in the middle.
    static openvdb::FloatGrid::Ptr ball(const std::string& name) {
        const auto grid = openvdb::FloatGrid::create(0.0f);
        grid->setName(name);
        grid->setTransform(openvdb::math::Transform::createLinearTransform(0.25));
        auto accessor = grid->getAccessor();
        for (int z = -6; z <= 6; ++z)
            for (int y = -6; y <= 6; ++y)
                for (int x = -6; x <= 6; ++x)
                    if (x * x + y * y + z * z <= 36) accessor.setValue({100 + x, y - 3, z + 7}, ball_value(x, y, z));
        return grid;
    }
    static float ball_value(int x, int y, int z) { return 1.0f - std::sqrt(float(x * x + y * y + z * z)) / 7.0f; }

    static std::string error_of(const fs::path& file, const GridChoice& grid = {}) {
        try {
            (void)load_volume(file, grid);
        } catch (const Error& error) {
            return error.what();
        }
        return "no error";
    }
    static void expect_error(const std::string& error, std::initializer_list<const char*> parts) {
        for (const char* part : parts) EXPECT_NE(error.find(part), std::string::npos) << part << "\nin: " << error;
    }
};

TEST_F(Volumes, ReadsTheActiveBoxOfAVdbGrid) {
    const fs::path file = write_vdb("ball.vdb", {ball("density"), ball("temperature")});
    std::vector<fs::path> sources;
    const Volume volume = load_volume(file, {}, &sources);
    EXPECT_EQ(volume.size, glm::ivec3(13));
    EXPECT_EQ(volume.voxel_m, glm::vec3(0.25f));
    for (int z = -6; z <= 6; ++z)
        for (int y = -6; y <= 6; ++y)
            for (int x = -6; x <= 6; ++x)
                ASSERT_EQ(volume.at(x + 6, y + 6, z + 6), x * x + y * y + z * z <= 36 ? ball_value(x, y, z) : 0.0f);
    EXPECT_TRUE(sources.empty()) << "the file itself is no further source";
    EXPECT_EQ(load_volume(file, "temperature").values, volume.values);
}

TEST_F(Volumes, MotionBlursAlongTheVelocity) {
    const auto wind = openvdb::Vec3SGrid::create(openvdb::Vec3s(2.0f, 0.0f, 0.0f));  // 2 units a second everywhere
    wind->setName("wind");
    wind->setTransform(openvdb::math::Transform::createLinearTransform(0.5));  // its own voxels
    const auto line = openvdb::FloatGrid::create(0.0f);
    line->setName("density");
    line->setTransform(openvdb::math::Transform::createLinearTransform(0.25));
    line->fill(openvdb::CoordBBox({0, 0, 0}, {40, 2, 2}), 1e-6f, true);
    line->fill(openvdb::CoordBBox({15, 0, 0}, {24, 2, 2}), 1.0f, true);
    const fs::path file = write_vdb("moving.vdb", {line, wind});
    const Volume still = load_volume(file);
    GridChoice choice("density");
    choice.velocity = "wind";
    EXPECT_EQ(load_volume(file, choice).values, still.values) << "a shutter that does not open";
    choice.shutter_s = 1.0f;  // 8 voxels
    const Volume blurred = load_volume(file, choice);
    ASSERT_EQ(blurred.size, still.size);
    float worst = 0.0f, sum = 0.0f, still_sum = 0.0f;
    for (int x = 0; x < blurred.size.x; ++x) {
        // a box of 10 voxels under a shutter of 8: a trapezium, 1 over the middle two
        const float away = std::abs(float(x) - 19.5f), expected = std::clamp((9.0f - away) / 8.0f, 0.0f, 1.0f);
        worst = std::max(worst, std::abs(blurred.at(x, 1, 1) - expected));
        sum += blurred.at(x, 1, 1), still_sum += still.at(x, 1, 1);
    }
    std::printf("worst difference from the trapezium %.4f, amount %.5f\n", double(worst), double(sum / still_sum));
    EXPECT_LT(worst, 0.02f);
    EXPECT_NEAR(sum / still_sum, 1.0f, 1e-3f);
    choice.velocity = "wnd";
    expect_error(error_of(file, choice), {"moving.vdb", "there is no grid 'wnd'", "did you mean 'wind'?"});
    choice.velocity = "density";
    expect_error(error_of(file, choice), {"moving.vdb", "'density' is of type", "a grid of vectors"});
}

TEST_F(Volumes, SaysWhichGridsThereAre) {
    const fs::path file = write_vdb("smoke.vdb", {ball("density"), ball("temperature")});
    expect_error(error_of(file, "densty"), {"smoke.vdb", "densty", "density, temperature", "did you mean 'density'?"});
    const auto vectors = openvdb::Vec3fGrid::create();
    vectors->setName("velocity");
    const auto level_set = ball("surface");
    level_set->setGridClass(openvdb::GRID_LEVEL_SET);
    const auto empty = openvdb::FloatGrid::create();
    empty->setName("empty");
    const fs::path others = write_vdb("others.vdb", {vectors, level_set, empty});
    expect_error(error_of(others, "velocity"), {"velocity", "a grid of floats"});
    expect_error(error_of(others, "surface"), {"surface", "level set"});
    expect_error(error_of(others, "empty"), {"others.vdb", "empty"});
}

TEST_F(Volumes, RefusesWhatIsTooLargeOrNotFinite) {
    const auto wide = openvdb::FloatGrid::create();
    wide->setName("density");
    wide->getAccessor().setValue({-3'000'000, 0, 0}, 1.0f);
    wide->getAccessor().setValue({3'000'000, 2'000'000, 9}, 1.0f);
    expect_error(error_of(write_vdb("wide.vdb", {wide})), {"wide.vdb", "6000001 x 2000001 x 10"});
    const auto broken = ball("density");
    broken->getAccessor().setValue({100, -3, 7}, NAN);
    expect_error(error_of(write_vdb("nan.vdb", {broken})), {"nan.vdb", "not finite"});
}

TEST_F(Volumes, ReadsRawFilesByTheirDescription) {
    write("a.raw", std::string("\x00\xff\x33\x66\x99\xcc", 6));
    std::vector<fs::path> sources;
    const fs::path file =
        write("a.json",
              R"({"raw": "a.raw", "type": "u8", "size": [3, 2, 1], "voxel_m": [0.1, 0.1, 0.2], "about": "a test"})");
    const Volume volume = load_volume(file, "ignored", &sources);
    EXPECT_EQ(volume.size, glm::ivec3(3, 2, 1));
    EXPECT_EQ(volume.voxel_m, glm::vec3(0.1f, 0.1f, 0.2f));
    EXPECT_NEAR(volume.at(1, 0, 0), 1.0f, 1e-6f);
    EXPECT_NEAR(volume.at(2, 1, 0), 0.8f, 1e-6f);
    EXPECT_EQ(sources, std::vector<fs::path>{fs::canonical(folder_ / "a.raw")});

    write("b.raw", std::string("\x80\x00\x00\xff", 4));
    const std::string b = R"({"raw": "b.raw", "type": "u16", "size": [2, 1, 1], "byte_order": )";
    EXPECT_NEAR(load_volume(write("b.json", b + "\"big\"}")).at(0, 0, 0), 32768.0f / 65535.0f, 1e-6f);
    EXPECT_NEAR(load_volume(write("b.json", b + "\"little\"}")).at(0, 0, 0), 128.0f / 65535.0f, 1e-6f);

    const float values[2] = {-2.5f, 1e6f};
    write("c.raw", std::string(reinterpret_cast<const char*>(values), sizeof values));
    const Volume floats = load_volume(write("c.json", R"({"raw": "c.raw", "type": "f32", "size": [1, 1, 2]})"));
    EXPECT_EQ(floats.values, (std::vector<float>{0.0f, 1e6f})) << "amounts are not negative";
}

TEST_F(Volumes, SaysWhatIsWrongWithADescription) {
    write("a.raw", "123456");
    const auto error = [&](const std::string& text) { return error_of(write("a.json", text)); };
    expect_error(error(R"({"raw": "a.raw", "type": "u8", "size": [3, 3, 1]})"), {"a.raw", "6 bytes", "9", "a.json"});
    expect_error(error(R"({"raw": "a.raw", "type": "u8", "sise": [3, 2, 1]})"), {"/sise", "did you mean 'size'?"});
    expect_error(error(R"({"raw": "a.raw", "type": "u8"})"), {"'size' is missing"});
    expect_error(error(R"({"raw": "a.raw", "type": "int", "size": [3, 2, 1]})"), {"/type", "'int'", "u8, u16 or f32"});
    expect_error(error(R"({"raw": "a.raw", "type": 8, "size": [3, 2, 1]})"), {"/type", "a text"});
    expect_error(error(R"({"raw": "a.raw", "type": "u8", "size": [3, 2.5, 1]})"), {"/size", "whole"});
    expect_error(error(R"({"raw": "a.raw", "type": "u8", "size": [65536, 65536, 65536]})"), {"65536 x 65536"});
    expect_error(error(R"({"raw": "a.raw", "type": "u8", "size": [-1, 2, 1]})"), {"/size", "out of range"});
    expect_error(error(R"({"raw": "../a.raw", "type": "u8", "size": [3, 2, 1]})"), {"../a.raw"});
    expect_error(error(R"({"raw": "b.raw", "type": "u8", "size": [3, 2, 1]})"), {"b.raw", "did you mean 'a.raw'?"});
    expect_error(error(R"({"type": "u8", "size": [3, 2, 1]})"), {"'raw' is missing"});
    expect_error(error("{"), {"a.json", "not JSON"});
}

TEST_F(Volumes, RefusesFilesOfOtherKinds) {
    expect_error(error_of(folder_ / "absent.vdb"), {"absent.vdb", "no such file"});
    expect_error(error_of(folder_), {"not a file"});
    expect_error(error_of(write("empty.vdb", "")), {"empty.vdb", "empty"});
    expect_error(error_of(write("text.vdb", "hello")), {"not a volume", "OpenVDB"});
}

TEST_F(Volumes, BrokenVdbFilesAreRefusedOrReadButNeverEndTheProgram) {
    const std::string whole = paths::read_file(write_vdb("whole.vdb", {ball("density")}));
    std::mt19937 random(3);
    int refused = 0;  // the cut ones at least
    for (int i = 0; i < 16; ++i) {
        std::string content = whole;
        if (i % 4 == 0) content.resize(random() % whole.size());
        const size_t reach = i % 4 == 1 ? 600 : content.size();  // names and types, or anything
        for (unsigned wounds = i % 4 == 0 ? 0 : 1 + random() % 4; wounds > 0; --wounds)
            content[random() % reach] = static_cast<char>(random());
        const std::string error = error_of(write("broken.vdb", content));
        if (error == "no error") continue;
        ++refused;
        expect_error(error, {"broken.vdb"});
    }
    EXPECT_GE(refused, 3);
}

}  // namespace
}  // namespace tyndall
