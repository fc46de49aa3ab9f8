#include "scene/components.h"

namespace tyndall {

void describe(StructBuilder<GltfComponent::Glow>& d) {
    d.doc("Nodes that give off more or less light than the file says.");
    d.field("nodes", &GltfComponent::Glow::nodes, "Their names; * stands for any text and ? for one character.");
    d.field("factor", &GltfComponent::Glow::factor, "Multiplies the emission of their materials.").range(0, 1e6);
}

void describe(StructBuilder<GltfComponent>& d) {
    d.doc("A glTF 2.0 file with its meshes, materials, lights and cameras, placed by the entity's transform.");
    d.field("file", &GltfComponent::file, "The .gltf or .glb file, relative to the scene.").asset("gltf");
    d.field("cast_shadow_exclude", &GltfComponent::cast_shadow_exclude,
            "Nodes that cast no shadow, by name; * stands for any text and ? for one character.");
    d.field("glow", &GltfComponent::glow,
            "How nodes' emission differs from the file's: windows at dusk, lamps that are off. Of several that fit a "
            "node the first counts.");
}

void describe(StructBuilder<MeshComponent>& d) {
    d.doc(
        "A mesh from a file or a simple shape. Shapes fit the box from -1/2 to 1/2 (the plane lies in it at y = 0, "
        "facing +Y), so the transform's scale is their size in metres.");
    d.field("file", &MeshComponent::file, "An OBJ, PLY, OFF or STL file, relative to the scene; in metres.")
        .asset("mesh");
    d.field("primitive", &MeshComponent::primitive, "A shape instead of a file.",
            {"none", "sphere", "box", "plane", "cylinder"});
    d.field("tessellation", &MeshComponent::tessellation, "Segments around a sphere or cylinder.").range(3, 512);
    d.field("subdivision_levels", &MeshComponent::subdivision_levels,
            "Catmull-Clark subdivisions of a file's polygons; each makes four times as many.")
        .range(0, 6);
    d.field("casts_shadow", &MeshComponent::casts_shadow, "Whether it casts shadows.");
}

namespace {

void describe_textures(StructBuilder<MaterialComponent>& d) {
    d.field("base_colour_texture", &MaterialComponent::base_colour_texture,
            "Multiplies base_colour; its alpha multiplies opacity.")
        .asset("texture");
    d.field("metallic_roughness_texture", &MaterialComponent::metallic_roughness_texture,
            "Green multiplies roughness, blue metallic.")
        .asset("texture");
    d.field("normal_texture", &MaterialComponent::normal_texture, "Tangent-space normals, +Y up as in glTF.")
        .asset("texture");
    d.field("occlusion_texture", &MaterialComponent::occlusion_texture, "Red is ambient occlusion.").asset("texture");
    d.field("emissive_texture", &MaterialComponent::emissive_texture, "Multiplies emissive_cd_m2.").asset("texture");
    d.field("diffuse_transmission_texture", &MaterialComponent::diffuse_transmission_texture,
            "Multiplies diffuse_transmission_colour; its alpha multiplies diffuse_transmission.")
        .asset("texture");
    d.field("uv_scale", &MaterialComponent::uv_scale, "Repeats of the textures over the unit of the mesh's UVs.");
}

}  // namespace

void describe(StructBuilder<MaterialComponent>& d) {
    d.doc(
        "Metallic-roughness material as glTF 2.0 has it, for the entity's mesh; on an entity with a gltf it replaces "
        "all of the file's materials.");
    using M = MaterialComponent;
    d.field("base_colour", &M::base_colour, "Diffuse albedo, or the metal's reflectance.").range(0, 1).colour();
    d.field("opacity", &M::opacity, "Coverage; used when alpha_mode is mask or blend.").range(0, 1);
    d.field("metallic", &M::metallic, "0 = dielectric, 1 = metal.").range(0, 1);
    d.field("roughness", &M::roughness, "Perceptual roughness; GGX alpha is its square.").range(0, 1);
    d.field("emissive_cd_m2", &M::emissive_cd_m2, "Light that the surface gives off.").unit("cd/m2").range(0, 1e9);
    d.field("normal_scale", &M::normal_scale, "Strength of the normal texture.").range(-10, 10);
    d.field("occlusion_strength", &M::occlusion_strength, "Strength of the occlusion texture.").range(0, 1);
    d.field("alpha_mode", &M::alpha_mode, "What opacity does.", {"opaque", "mask", "blend"});
    d.field("alpha_cutoff", &M::alpha_cutoff, "With mask: less opaque texels are holes.").range(0, 1);
    d.field("double_sided", &M::double_sided, "Whether the back is lit as well.");
    d.field("ior", &M::ior, "Index of refraction of a dielectric.").range(1, 4);
    d.field("specular", &M::specular, "Scales a dielectric's reflection.").range(0, 1);
    d.field("specular_colour", &M::specular_colour, "Tints a dielectric's reflection.").range(0, 1).colour();
    d.field("transmission", &M::transmission, "Share of light that passes instead of being diffused.").range(0, 1);
    d.field("thickness_m", &M::thickness_m, "Thickness of what is below the surface.").unit("m").range(0, 1e4);
    d.field("attenuation_colour", &M::attenuation_colour, "Colour of white light after attenuation_distance_m.")
        .range(0, 1)
        .colour();
    d.field("attenuation_distance_m", &M::attenuation_distance_m, "0 = it attenuates nothing.").unit("m").range(0, 1e6);
    d.field("diffuse_transmission", &M::diffuse_transmission,
            "Share of the diffuse light that goes through a thin surface (leaf, paper, cloth) instead of back; the "
            "module translucency shows it.")
        .range(0, 1);
    d.field("diffuse_transmission_colour", &M::diffuse_transmission_colour, "Colour of what goes through.")
        .range(0, 1)
        .colour();
    describe_textures(d);
    d.field("shading_model", &M::shading_model, "How light is reflected: standard, or one that a module brings.");
}

void describe(StructBuilder<ColliderComponent>& d) {
    d.doc("A walking camera collides with the meshes of this entity and of all below it.");
}

void describe(StructBuilder<TransientComponent>& d) {
    d.doc("Not saved, with all below it.");
}

}  // namespace tyndall
