#include <algorithm>

#include "core/error.h"
#include "scene/scattering_components.h"

namespace tyndall {
namespace {

/// From a box to [0, 1]^3 over a volume that fills it, or lies in its middle as large as its own proportions allow.
glm::mat4 to_volume(const Bounds& box, const Volume& volume, VolumeFit fit, const glm::mat4& local_to_world) {
    glm::vec3 extent = glm::max(box.size(), glm::vec3(1e-12f));
    if (fit == VolumeFit::contain) {
        const glm::vec3 volume_m = glm::vec3(volume.size) * volume.voxel_m;
        glm::vec3 share;  // of the box's edge, before all shrink alike
        for (int axis = 0; axis < 3; ++axis) {
            const float edge_m = extent[axis] * glm::length(glm::vec3(local_to_world[axis]));
            share[axis] = volume_m[axis] / std::max(edge_m, 1e-12f);
        }
        extent *= share / std::max({share.x, share.y, share.z});
    }
    glm::mat4 map(1.0f);
    for (int axis = 0; axis < 3; ++axis) {
        map[axis][axis] = 1.0f / extent[axis];
        map[3][axis] = 0.5f - box.centre()[axis] / extent[axis];
    }
    return map;
}

}  // namespace

void describe(StructBuilder<ConstantDensity>& d) {
    d.doc("The same everywhere.");
}

void describe(StructBuilder<HeightDensity>& d) {
    d.doc("Falls with the height in the world, exp(-(y - base_m) / scale_height_m), as ground fog and the air do.");
    d.field("base_m", &HeightDensity::base_m, "Height at which the density is 1.").unit("m").range(-1e6, 1e6);
    d.field("scale_height_m", &HeightDensity::scale_height_m, "Over this height it falls to 37 %.")
        .unit("m")
        .range(1e-3, 1e6);
}

void describe(StructBuilder<BlobDensity::Blob>& d) {
    using B = BlobDensity::Blob;
    d.doc("weight exp(-distance^2 / (2 radius^2)), in the unit box of a medium or the space of a mesh.");
    d.field("centre", &B::centre, "Its middle.").range(-1e6, 1e6);
    d.field("radius", &B::radius, "Standard deviation.").range(1e-6, 1e6);
    d.field("weight", &B::weight, "Density in its middle.").range(0.0, 1e6);
}

void describe(StructBuilder<BlobDensity>& d) {
    d.doc("A sum of Gaussian blobs.");
    d.field("blobs", &BlobDensity::blobs, "The blobs.");
}

void describe(StructBuilder<NoiseDensity>& d) {
    d.doc("Fractal noise between 0 and 1, fixed in the world: clouds and drifting smoke.");
    d.field("feature_m", &NoiseDensity::feature_m, "Size of the largest features.").unit("m").range(1e-4, 1e6);
    d.field("octaves", &NoiseDensity::octaves,
            "Levels of detail, each half as large and half as strong; time grows with them.")
        .range(1, 16);
    d.field("coverage", &NoiseDensity::coverage, "Share of space that is not empty, roughly.").range(0.0, 1.0);
    d.field("wind_m_s", &NoiseDensity::wind_m_s, "Moves it with the time.").unit("m/s").range(-1e3, 1e3);
}

void describe(StructBuilder<VolumeDensity>& d) {
    using V = VolumeDensity;
    d.doc("A grid of voxels from a file, linear between them.");
    d.field("file", &V::file, "An OpenVDB file, or a JSON description of a raw one, relative to the scene.")
        .asset("volume");
    d.field("grid", &V::grid, "Which grid of an OpenVDB file; empty = density.");
    d.field("scale", &V::scale, "Multiplies its values.").range(0.0, 1e9);
    d.field("fit", &V::fit, "stretch fills the box; contain keeps the voxels' proportions.", {"stretch", "contain"});
}

std::vector<std::string> density_names() {
    return {"constant", "height", "blobs", "noise", "volume"};
}

DensityField make_density(const DensityChoice& choice, AssetStore& assets, const Bounds& box,
                          const glm::mat4& local_to_world) {
    return std::visit(
        [&](const auto& density) -> DensityField {
            if constexpr (std::is_same_v<std::decay_t<decltype(density)>, VolumeDensity>) {
                if (density.file.empty()) throw Error("a density from a volume needs a file");
                GridDensity grid{assets.volume(density.file, density.grid), glm::mat4(1.0f), density.scale};
                grid.to_volume = to_volume(box, grid.volume->volume, density.fit, local_to_world);
                return grid;
            } else {
                return density;
            }
        },
        choice);
}

}  // namespace tyndall
