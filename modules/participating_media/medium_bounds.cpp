#include "medium_bounds.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include "core/error.h"
#include "scene/primitives.h"

namespace tyndall::participating_media {
namespace {

constexpr float kScaleHeights = 8.0f;  ///< of a layer without a top: what is above is 0.03 % as dense as its base

PlacedBounds boxed(MediumShape shape, const glm::mat4& transform) {
    PlacedBounds placed;
    placed.shape = shape;
    placed.transform = transform;
    return placed;
}

/// A box around a mask that is in the entity's space.
PlacedBounds masked(std::shared_ptr<const VolumeAsset> mask, const glm::mat4& transform) {
    const Volume& volume = mask->volume;
    const glm::vec3 size = glm::vec3(volume.size) * volume.voxel_m;
    PlacedBounds placed =
        boxed(MediumShape::box, glm::scale(glm::translate(transform, volume.low_m + 0.5f * size), size));
    placed.mask = GridDensity{std::move(mask), glm::translate(glm::mat4(1.0f), glm::vec3(0.5f))};
    return placed;
}

struct Place {
    const ExtractContext& context;

    PlacedBounds operator()(const BoxBounds&) const { return boxed(MediumShape::box, context.transform); }
    PlacedBounds operator()(const EllipsoidBounds&) const { return boxed(MediumShape::ellipsoid, context.transform); }
    PlacedBounds operator()(const WholeSceneBounds&) const {
        return boxed(MediumShape::whole_scene, context.transform);
    }

    PlacedBounds operator()(const LayerBounds& layer) const {
        PlacedBounds placed = boxed(MediumShape::layer, context.transform);
        placed.low_m = layer.base_m;
        placed.high_m =
            layer.top_m > 0.0f ? layer.base_m + layer.top_m : layer.base_m + kScaleHeights * layer.scale_height_m;
        placed.layer = HeightDensity{layer.base_m, layer.scale_height_m};
        return placed;
    }

    PlacedBounds operator()(const MeshBounds& mesh) const {
        if ((mesh.primitive == Primitive::none) == mesh.file.empty())
            throw Error("bounds of a mesh need a file or a primitive, and not both");
        if (mesh.primitive == Primitive::none)
            return masked(context.assets.mesh_mask(*context.assets.mesh(mesh.file), mesh.resolution),
                          context.transform);
        return masked(context.assets.mesh_mask(primitive(mesh.primitive), mesh.resolution), context.transform);
    }

    PlacedBounds operator()(const ParticleBounds& set) const {
        if (set.particles.empty() == set.file.empty())
            throw Error("bounds of particles need a file or a list of particles, and not both");
        std::vector<Particle> particles;
        if (set.file.empty())
            for (const ParticleChoice& p : set.particles) particles.push_back({p.centre, p.radius_m, p.weight});
        else
            particles = context.assets.particles(set.file)->particles;
        for (Particle& p : particles)
            if (!(p.radius_m > 0.0f)) p.radius_m = set.radius_m;
        return masked(context.assets.particle_mask(particles, set.resolution), context.transform);
    }

 private:
    /// A mesh of an id of its own for each kind: it is made once.
    static const MeshAsset& primitive(Primitive shape) {
        static const MeshAsset meshes[] = {made(Primitive::sphere, "sphere"), made(Primitive::box, "box"),
                                           made(Primitive::plane, "plane"), made(Primitive::cylinder, "cylinder")};
        return meshes[static_cast<size_t>(shape) - 1];
    }
    static MeshAsset made(Primitive shape, const char* name) {
        return {.id = new_asset_id(), .name = name, .mesh = make_primitive(shape, 64)};
    }
};

}  // namespace

void describe(StructBuilder<BoxBounds>& d) {
    d.doc("The unit box around the entity, scaled and turned by its transform.");
}

void describe(StructBuilder<WholeSceneBounds>& d) {
    d.doc("The bounding box of all surfaces, lights and the camera: fog without an end would let no sunlight in.");
}

void describe(StructBuilder<EllipsoidBounds>& d) {
    d.doc("The ball that touches the unit box's sides, scaled and turned by the entity's transform.");
}

void describe(StructBuilder<LayerBounds>& d) {
    using L = LayerBounds;
    d.doc("A layer over the whole scene that thins with the height, as ground fog and the air do; nothing below it.");
    d.field("base_m", &L::base_m, "Height of its lower side, where the density is 1.").unit("m").range(-1e6, 1e6);
    d.field("scale_height_m", &L::scale_height_m, "Over this height it thins to 37 %.").unit("m").range(1e-3, 1e6);
    d.field("top_m", &L::top_m, "Its thickness, where it is cut off; 0 = eight scale heights.")
        .unit("m")
        .range(0.0, 1e6);
}

void describe(StructBuilder<MeshBounds>& d) {
    using M = MeshBounds;
    d.doc(
        "The inside of a closed mesh in the entity's space, on voxels: the surface is blurred over the width of one. A "
        "mesh that is not closed has no inside, and the medium is left out.");
    d.field("file", &M::file, "An OBJ, PLY, OFF or STL file, relative to the scene; in metres.").asset("mesh");
    d.field("primitive", &M::primitive, "A shape instead of a file.", {"none", "sphere", "box", "plane", "cylinder"});
    d.field("resolution", &M::resolution, "Voxels along the longest edge of its bounds.").range(4, 512);
}

void describe(StructBuilder<ParticleChoice>& d) {
    using P = ParticleChoice;
    d.doc("A soft ball: its density is weight (1 - (distance / radius)^2)^2.");
    d.field("centre", &P::centre, "Its middle, in the entity's space.").unit("m").range(-1e6, 1e6);
    d.field("radius_m", &P::radius_m, "Its radius.").unit("m").range(1e-6, 1e6);
    d.field("weight", &P::weight, "Density in its middle.").range(0.0, 1e6);
}

void describe(StructBuilder<ParticleBounds>& d) {
    using P = ParticleBounds;
    d.doc("Soft balls whose densities add, any number of them, rasterised into voxels.");
    d.field("file", &P::file, "A PLY file's vertices, or a text file of lines `x y z [radius [weight]]`.")
        .asset("particles");
    d.field("radius_m", &P::radius_m, "Radius of those of a file that have none.").unit("m").range(1e-6, 1e6);
    d.field("resolution", &P::resolution, "Voxels along the longest edge of the box around all.").range(4, 512);
    d.field("particles", &P::particles, "Balls instead of a file.");
}

std::vector<std::string> bounds_names() {
    return {"box", "whole_scene", "ellipsoid", "layer", "mesh", "particles"};
}

PlacedBounds place_bounds(const BoundsChoice& choice, const ExtractContext& context) {
    PlacedBounds placed = std::visit(Place{context}, choice);
    if (!placed.whole() && !(std::abs(glm::determinant(glm::mat3(placed.transform))) > 0.0f))
        throw Error("the medium has no volume: its entity, or one above it, is scaled by 0 (expected a scale above 0)");
    return placed;
}

}  // namespace tyndall::participating_media
