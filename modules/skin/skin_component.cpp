#include "skin_component.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>

#include "core/error.h"
#include "geometry/curvature.h"
#include "skin_maps.h"
#include "skin_thickness.h"
#include "texture_space/surface_maps.h"
#include "texture_space/usable_maps.h"

namespace tyndall::skin {
namespace {

/// Curvature is what skin spreads over: smoothed over as many metres.
constexpr float kCurvatureSmoothing_m = 0.003f;

/// Thickness that does not scale to nothing, and albedos that shares are not divided by.
constexpr float kLeastStrength = 1e-3f;
constexpr float kLeastAlbedo = 0.02f;

/// What the extractor made for a surface.
struct Made {
    SkinComponent component;
    uint64_t material_id = 0, mesh_id = 0;
    float scale = 0.0f;
    std::array<int, 6> stretch{};
    std::shared_ptr<const Material> material;
    std::shared_ptr<const MeshAsset> mesh;
    std::shared_ptr<const SurfaceDiffusion> diffusion;
};

std::shared_ptr<const Material> skin_material(const Material& from, const SkinComponent& component, AssetStore& assets,
                                              bool boundary) {
    auto made = std::make_shared<Material>(from);
    set_maps(component.maps, assets, *made);
    made->id = new_asset_id();
    made->shading_model = "skin";
    made->shading_parameters = {component.lobe_roughness.x, component.lobe_roughness.y, component.second_lobe,
                                component.specular == Specular::kelemen ? 1.0f : 0.0f};
    made->metallic = 0.0f;
    if (!boundary) made->ior = kSkinIor;
    return made;
}

std::shared_ptr<const MeshAsset> curved(const MeshAsset& from, float scale) {
    auto made = std::make_shared<MeshAsset>(from);
    made->id = new_asset_id();
    compute_curvatures(made->mesh, kCurvatureSmoothing_m / scale);
    return made;
}

/// The scale of a transform, by volume; 0 for what is flat.
float scale_of(const glm::mat4& transform) {
    return std::cbrt(std::abs(glm::determinant(glm::mat3(transform))));
}

class SkinExtractor {
 public:
    void operator()(const ExtractContext& context, const SkinComponent& component, RenderScene& scene) {
        size_t found = 0;
        for (Surface& surface : scene.surfaces) {
            if (surface.entity.index != context.entity.index || surface.entity.generation != context.entity.generation)
                continue;
            make(context, component, surface, found++);
        }
        if (found == 0) throw Error("skin needs a mesh or a gltf on the same entity");
    }

 private:
    using Key = std::tuple<uint32_t, uint32_t, size_t>;  ///< entity, which of its surfaces

    void make(const ExtractContext& context, const SkinComponent& component, Surface& surface, size_t which) {
        const float scale = scale_of(surface.transform);
        if (!(scale > 0.0f) || surface.mesh->mesh.normals.empty()) return;  // nothing of it is seen
        if (made_.size() > 64 + 4 * context.world.size())
            std::erase_if(made_, [&](const auto& entry) {
                return !context.world.alive({std::get<0>(entry.first), std::get<1>(entry.first)});
            });
        Made& made = made_[{context.entity.index, context.entity.generation, which}];
        const bool changed = !made.material || made.component != component;
        const std::array<int, 6> stretch = stretch_of(surface.transform).key;
        if (changed || made.material_id != surface.material->id)
            made.material = skin_material(*surface.material, component, context.assets, surface.interior.has_value());
        if (made.mesh_id != surface.mesh->id || std::abs(scale - made.scale) > 0.05f * made.scale)
            made.mesh = curved(*surface.mesh, made.scale = scale);
        if (changed || made.mesh_id != surface.mesh->id || made.stretch != stretch)
            made.diffusion = diffusion_of(component, surface, context.assets);
        made.component = component;
        made.stretch = stretch;
        made.material_id = surface.material->id;
        made.mesh_id = surface.mesh->id;
        surface.material = made.material;
        surface.mesh = made.mesh;
        surface.diffusion = made.diffusion;
    }

    std::shared_ptr<const SurfaceDiffusion> diffusion_of(const SkinComponent& component, const Surface& surface,
                                                         AssetStore& assets) {
        auto made = std::make_shared<SurfaceDiffusion>();
        const std::shared_ptr<const MadeProfile> profile = made_profile(component.profile);
        made->profile = adjusted(profile->profile, component);
        if (profile->transmittance)
            made->through = std::make_shared<physics::SlabTransmittance>(
                profile->transmittance->scaled(std::max(component.strength, kLeastStrength),
                                               component.tint / glm::max(profile->albedo, kLeastAlbedo)));
        made->corrections = profile->corrections;
        made->corrections.drift_m *= component.strength;
        made->corrections.convex_m *= component.strength;
        made->pre_scatter = component.pre_scatter;
        made->transmission = component.transmission;
        made->detail_m = component.detail_mm * 1e-3f;
        if (component.transmission > 0.0f) made->thickness = thicknesses_.of(component, surface, assets);
        // a mesh whose UVs are no map is done on the screen
        const bool in_map = component.technique == Technique::six_gaussians || component.technique == Technique::hable;
        const Technique technique = in_map && !usable_.usable(*surface.mesh, surface.material->name)
                                        ? Technique::separable
                                        : component.technique;
        made->technique = technique_names()[static_cast<size_t>(technique)];
        return made;
    }

    std::map<Key, Made> made_;
    UsableMaps usable_;
    Thicknesses thicknesses_;
};

}  // namespace

void describe(StructBuilder<SkinMaps>& d) {
    using M = SkinMaps;
    d.doc("Texture files by uv0; an empty name leaves what the material has.");
    d.field("colour", &M::colour, "What comes back of diffuse light.").asset("texture");
    d.field("normal", &M::normal, "Tangent-space normals: pores and wrinkles.").asset("texture");
    d.field("roughness", &M::roughness, "Perceptual roughness, first channel; multiplies the material's.")
        .asset("texture");
    d.field("specular", &M::specular, "Strength of the mirror, first channel.").asset("texture");
    d.field("cavity", &M::cavity, "Where pores and folds hide the mirror: 0 = hidden, first channel.").asset("texture");
    d.field("oiliness", &M::oiliness, "0 = dry, 1 = oily: half as rough, first channel.").asset("texture");
    d.field("thickness", &M::thickness,
            "How thick the skin is along the inward normal, for light through thin parts: 1 is thickness_mm, first "
            "channel.")
        .asset("texture");
}

void describe(StructBuilder<SkinComponent>& d) {
    using S = SkinComponent;
    d.doc(
        "Makes the entity's mesh, or all of its gltf, skin: light that enters spreads under it, in millimetres of the "
        "world, and leaves beside; an oily layer mirrors. Colour and maps are the material's unless given here. With "
        "an "
        "interior beside it, the reference path tracer shows that and real time this.");
    d.field("profile", &S::profile, "How light spreads.", profile_names());
    d.field("technique", &S::technique, "What renders it; six_gaussians and hable need UVs without overlaps.",
            technique_names());
    d.field("tint", &S::tint, "An artist's choice: the share of each channel that spreads; 1 is what the profile says.")
        .range(0.0, 1.0)
        .colour();
    d.field("strength", &S::strength, "An artist's choice: distances times this; 1 is what the profile says.")
        .range(0.0, 100.0);
    d.field(
         "pre_scatter", &S::pre_scatter,
         "The colour to this power counts where light enters, the rest where it leaves: 0 keeps it sharp, 1 blurs it "
         "as light is. Techniques of the light pass have it where light leaves, and so have those on the screen and in "
         "the map for colour textures by the second UV set.")
        .range(0.0, 1.0);
    d.field("transmission", &S::transmission, "Share of the light through thin parts that is shown.").range(0.0, 1.0);
    d.field(
        "thickness", &S::thickness,
        "What light through thin parts goes by. given: shadow maps, and where there are none (lights without, light "
        "from all around) the map of thickness if there is one. others: the same, and a thickness baked from the mesh "
        "if there is no map. all: thickness for all lights.",
        {"given", "others", "all"});
    d.field("thickness_mm", &S::thickness_mm, "Millimetres of the world that 1 of the map of thickness stands for.")
        .unit("mm")
        .range(0.001, 10000.0);
    d.field("specular", &S::specular,
            "The oily layer: two lobes of GGX, or Kelemen & Szirmay-Kalos (2001) with Beckmann's.",
            {"two_lobes", "kelemen"});
    d.field("lobe_roughness", &S::lobe_roughness, "Roughness of both lobes over the surface's.").range(0.05, 4.0);
    d.field("second_lobe", &S::second_lobe, "Share of the second lobe.").range(0.0, 1.0);
    d.field("detail_mm", &S::detail_mm,
            "Wavelength of the normal map's detail: blurred_normals and preintegrated flatten what light spreads over.")
        .unit("mm")
        .range(0.001, 1000.0);
    d.field("maps", &S::maps, "Textures.");
}

physics::DiffusionProfile adjusted(physics::DiffusionProfile profile, const SkinComponent& component) {
    constexpr float kUnspread_m2 = 1e-12f;  // a micrometre
    for (physics::DiffusionLobe& lobe : profile.lobes) {
        lobe.variance_m2 = std::max(lobe.variance_m2 * component.strength * component.strength, kUnspread_m2);
        lobe.weight *= component.tint;
    }
    if (component.tint != glm::vec3(1.0f)) profile.lobes.push_back({kUnspread_m2, glm::vec3(1.0f) - component.tint});
    profile.normalise();
    return profile;
}

Extractor make_skin_extractor() {
    return [extractor = std::make_shared<SkinExtractor>()](const ExtractContext& context, const void* component,
                                                           RenderScene& scene) {
        (*extractor)(context, *static_cast<const SkinComponent*>(component), scene);
    };
}

}  // namespace tyndall::skin
