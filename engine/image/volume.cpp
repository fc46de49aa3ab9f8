#include "image/volume.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <new>

#include "core/error.h"
#include "core/paths.h"
#include "image/volume_readers.h"

namespace tyndall {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view kVdbMark = " BDV\0\0\0\0"sv;  // openvdb::OPENVDB_MAGIC
constexpr std::string_view kKnownKinds = "an OpenVDB file, or a JSON description of a raw file";

[[noreturn]] void fail(const std::filesystem::path& file, std::string message, std::string expected = {}) {
    throw Error(Diagnostic{{file.string()}, std::move(message), std::move(expected), {}});
}

std::string first_bytes(const std::filesystem::path& file) {
    if (!std::filesystem::exists(file)) fail(file, "no such file");
    if (!std::filesystem::is_regular_file(file)) fail(file, "not a file");
    std::ifstream in(file, std::ios::binary);
    std::string bytes(64, '\0');
    in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<size_t>(in.gcount()));
    return bytes;
}

Volume read_moving_vdb(const std::filesystem::path& file, const GridChoice& grid) {
    Volume volume = load_vdb(file, grid.name.empty() ? kDefaultGrid : grid.name);
    if (grid.velocity.empty() || grid.shutter_s == 0.0f) return volume;
    return blurred_by_motion(volume, load_vdb_vectors(file, grid.velocity, volume), grid.shutter_s);
}

Volume read(const std::filesystem::path& file, const GridChoice& grid, std::vector<std::filesystem::path>& sources) {
    const std::string head = first_bytes(file);
    if (head.starts_with(kVdbMark)) return read_moving_vdb(file, grid);
    if (!grid.velocity.empty()) fail(file, "a raw volume has no grid of velocities", "an OpenVDB file");
    const size_t start = head.find_first_not_of(" \t\r\n");
    if (start != std::string::npos && head[start] == '{') return load_raw_volume(file, paths::read_file(file), sources);
    fail(file, head.empty() ? "the file is empty" : "not a volume of a known kind", std::string(kKnownKinds));
}

}  // namespace

void check_volume_size(const std::filesystem::path& file, int64_t x, int64_t y, int64_t z) {
    const bool some = x > 0 && y > 0 && z > 0;
    if (some && x <= kMaxVoxels && y <= kMaxVoxels / x && z <= kMaxVoxels / (x * y)) return;
    fail(file, fmt::format("a volume of {} x {} x {} voxels", x, y, z),
         fmt::format("at least one, and at most {} in all", kMaxVoxels));
}

Volume load_volume(const std::filesystem::path& file, const GridChoice& grid,
                   std::vector<std::filesystem::path>* sources) {
    std::vector<std::filesystem::path> unused;
    try {
        Volume volume = read(file, grid, sources ? *sources : unused);
        if (!std::ranges::all_of(volume.values, [](float value) { return std::isfinite(value); }))
            fail(file, "the volume has values that are not finite numbers");
        for (float& value : volume.values) value = std::max(value, 0.0f);  // amounts; filters may undershoot a little
        return volume;
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        fail(file, "the volume does not fit into memory, or the file is corrupt");
    } catch (const std::exception& error) {
        fail(file, std::string("the volume cannot be read: ") + error.what());
    }
}

glm::mat4 to_unit_box(const Volume& volume) {
    glm::mat4 map(1.0f);
    for (int axis = 0; axis < 3; ++axis) {
        const float edge = static_cast<float>(volume.size[axis]) * volume.voxel_m[axis];
        map[axis][axis] = 1.0f / edge;
        map[3][axis] = -volume.low_m[axis] / edge;
    }
    return map;
}

}  // namespace tyndall
