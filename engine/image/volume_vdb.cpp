#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/Dense.h>
#include <openvdb/tools/Interpolation.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <mutex>

#include "core/error.h"
#include "image/isolated.h"
#include "image/volume_readers.h"

namespace tyndall {
namespace {

/// The grids of an OpenVDB file. openvdb::io::File reads on past the end of a broken file, for hours; a stream that
/// throws there ends it.
struct VdbFile {
    const std::filesystem::path& path;
    openvdb::GridPtrVecPtr grids;

    explicit VdbFile(const std::filesystem::path& from) : path(from) {
        static std::once_flag initialised;
        std::call_once(initialised, [] { openvdb::initialize(); });
        std::ifstream stream(path, std::ios::binary);
        stream.exceptions(std::ios::failbit | std::ios::badbit | std::ios::eofbit);
        try {
            grids = openvdb::io::Stream(stream, false).getGrids();
        } catch (const std::ios::failure&) {
            fail("the file is cut off, corrupt, or cannot be read");
        }
    }

    [[noreturn]] void fail(std::string message, std::string expected = {}, std::string suggestion = {}) const {
        throw Error(Diagnostic{{path.string()}, std::move(message), std::move(expected), std::move(suggestion)});
    }

    /// `kind` says what a Grid is, for people.
    template <class Grid>
    [[nodiscard]] typename Grid::Ptr grid(const std::string& name, const char* kind) const {
        const auto found = std::ranges::find_if(*grids, [&](const auto& grid) { return grid->getName() == name; });
        if (found == grids->end()) fail_missing(name);
        const openvdb::GridBase::Ptr& base = *found;
        auto grid = openvdb::gridPtrCast<Grid>(base);
        if (!grid) fail("the grid '" + name + "' is of type " + base->type(), kind);
        if (grid->getGridClass() == openvdb::GRID_LEVEL_SET)
            fail("the grid '" + name + "' is a level set: it holds distances", "a fog volume, which holds densities");
        if (!grid->transform().isLinear())
            fail("the grid '" + name + "' lies in a frustum", "a grid of voxels that are all alike");
        return grid;
    }

 private:
    [[noreturn]] void fail_missing(const std::string& name) const {
        std::vector<std::string> names;
        std::string all;
        for (const auto& grid : *grids) {
            names.push_back(grid->getName());
            all += (all.empty() ? "" : ", ") + grid->getName();
        }
        fail("there is no grid '" + name + "'", all.empty() ? "a file with grids" : "one of: " + all,
             nearest_name(name, names));
    }
};

/// How a Volume crosses from one process to the other, before its values.
struct Header {
    glm::ivec3 size;
    glm::vec3 voxel_m, low_m;
};

/// Where the low corner of the box is; grids that are turned are taken as if they were not.
glm::vec3 low_corner(const openvdb::math::Transform& transform, const openvdb::Coord& first) {
    const openvdb::Vec3d low = transform.indexToWorld(first.asVec3d() - openvdb::Vec3d(0.5));
    return {low.x(), low.y(), low.z()};
}

std::string read_grid(const std::filesystem::path& path, const std::string& name) {
    const VdbFile file(path);
    const openvdb::FloatGrid::Ptr grid = file.grid<openvdb::FloatGrid>(name, "a grid of floats");
    const openvdb::CoordBBox box = grid->evalActiveVoxelBoundingBox();
    if (box.empty()) file.fail("the grid '" + name + "' is empty");
    const auto extent = [&](size_t axis) { return int64_t{box.max()[axis]} - int64_t{box.min()[axis]} + 1; };
    check_volume_size(path, extent(0), extent(1), extent(2));
    const openvdb::Vec3d voxel = grid->voxelSize();
    Header header{glm::ivec3(extent(0), extent(1), extent(2)), glm::vec3(voxel.x(), voxel.y(), voxel.z()),
                  low_corner(grid->transform(), box.min())};
    for (int axis = 0; axis < 3; ++axis)
        if (!(header.voxel_m[axis] > 0.0f && header.voxel_m[axis] < 1e9f))
            file.fail("the voxels of grid '" + name + "' have no size");
    std::string bytes(sizeof(Header) + sizeof(float) * static_cast<size_t>(extent(0) * extent(1) * extent(2)), '\0');
    std::memcpy(bytes.data(), &header, sizeof(Header));
    openvdb::tools::Dense<float, openvdb::tools::LayoutXYZ> dense(
        box, reinterpret_cast<float*>(bytes.data() + sizeof(Header)));
    openvdb::tools::copyToDense(*grid, dense, true);  // true: on this thread alone
    return bytes;
}

std::string read_vectors(const std::filesystem::path& path, const std::string& name, const Volume& like) {
    const VdbFile file(path);
    const auto grid = file.grid<openvdb::Vec3SGrid>(name, "a grid of vectors of three floats");
    std::string bytes(like.values.size() * sizeof(glm::vec3), '\0');
    auto* to = reinterpret_cast<float*>(bytes.data());
    const openvdb::Vec3SGrid::ConstAccessor accessor = grid->getConstAccessor();  // the sampler only refers to it
    const openvdb::tools::GridSampler<openvdb::Vec3SGrid::ConstAccessor, openvdb::tools::BoxSampler> sampler(
        accessor, grid->transform());
    for (int z = 0; z < like.size.z; ++z)
        for (int y = 0; y < like.size.y; ++y)
            for (int x = 0; x < like.size.x; ++x) {
                const glm::dvec3 place =
                    glm::dvec3(like.low_m) + (glm::dvec3(x, y, z) + 0.5) * glm::dvec3(like.voxel_m);
                const openvdb::Vec3s vector = sampler.wsSample({place.x, place.y, place.z});
                *to++ = vector.x(), *to++ = vector.y(), *to++ = vector.z();
            }
    return bytes;
}

}  // namespace

std::vector<glm::vec3> load_vdb_vectors(const std::filesystem::path& path, std::string_view name, const Volume& like) {
    const std::string bytes = run_isolated(path, [&] { return read_vectors(path, std::string(name), like); });
    std::vector<glm::vec3> vectors(like.values.size());
    if (bytes.size() != vectors.size() * sizeof(glm::vec3))
        throw Error(Diagnostic{{path.string()}, "reading it gave nothing", {}, {}});
    std::memcpy(vectors.data(), bytes.data(), bytes.size());
    return vectors;
}

Volume load_vdb(const std::filesystem::path& path, std::string_view name) {
    const std::string bytes = run_isolated(path, [&] { return read_grid(path, std::string(name)); });
    Header header{};
    if (bytes.size() < sizeof(Header)) throw Error(Diagnostic{{path.string()}, "reading it gave nothing", {}, {}});
    std::memcpy(&header, bytes.data(), sizeof(Header));
    Volume volume{header.size, header.voxel_m, header.low_m, {}};
    volume.values.resize((bytes.size() - sizeof(Header)) / sizeof(float));
    std::memcpy(volume.values.data(), bytes.data() + sizeof(Header), volume.values.size() * sizeof(float));
    return volume;
}

}  // namespace tyndall
