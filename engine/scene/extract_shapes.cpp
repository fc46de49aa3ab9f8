#include <algorithm>
#include <map>

#include "geometry/subdivision.h"
#include "scene/components.h"
#include "scene/engine_extraction.h"
#include "scene/primitives.h"
#include "scene/scattering_components.h"

namespace tyndall {
namespace {

/// An entity as a key: slots are used again, generations are not.
using EntityKey = std::pair<uint32_t, uint32_t>;
EntityKey key_of(Entity entity) {
    return {entity.index, entity.generation};
}

/// Forgets entities that are no more, now and then.
template <class Map>
void drop_dead(Map& map, const World& world) {
    if (map.size() > 64 + 2 * world.size())
        std::erase_if(map, [&](const auto& entry) { return !world.alive({entry.first.first, entry.first.second}); });
}

/// Whether a walking camera collides with an entity's meshes.
bool collides(const World& world, Entity entity) {
    for (Entity at = entity; at; at = world.parent(at))
        if (world.find<ColliderComponent>(at)) return true;
    return false;
}

/// Materials of MaterialComponents, made again only when something in them changed.
class Materials {
 public:
    /// Null when the entity has no MaterialComponent.
    std::shared_ptr<const Material> of(const ExtractContext& context) {
        const auto* component = context.world.find<MaterialComponent>(context.entity);
        if (!component) return nullptr;
        const Textures textures = load(context.assets, *component);
        drop_dead(entries_, context.world);
        Entry& entry = entries_[key_of(context.entity)];
        if (!entry.material || entry.component != *component || entry.textures != textures) {
            entry.component = *component;
            entry.textures = textures;
            entry.material = make(*component, textures, context.world.name(context.entity));
        }
        return entry.material;
    }

    /// What meshes without a material are made of.
    std::shared_ptr<const Material> plain() {
        if (!plain_) plain_ = make(MaterialComponent{}, {}, "plain");
        return plain_;
    }

 private:
    using Texture = std::shared_ptr<const TextureAsset>;
    struct Textures {
        Texture base_colour, metallic_roughness, normal, occlusion, emissive, diffuse_transmission;
        bool operator==(const Textures&) const = default;
    };
    struct Entry {
        MaterialComponent component;
        Textures textures;
        std::shared_ptr<const Material> material;
    };

    static Textures load(AssetStore& assets, const MaterialComponent& from) {
        const auto texture = [&](const std::string& name, TextureUse use) {
            return name.empty() ? Texture{} : assets.texture(name, use);
        };
        return {texture(from.base_colour_texture, TextureUse::colour),
                texture(from.metallic_roughness_texture, TextureUse::data),
                texture(from.normal_texture, TextureUse::data),
                texture(from.occlusion_texture, TextureUse::data),
                texture(from.emissive_texture, TextureUse::colour),
                texture(from.diffuse_transmission_texture, TextureUse::colour)};
    }

    static std::shared_ptr<const Material> make(const MaterialComponent& from, const Textures& textures,
                                                const std::string& name) {
        auto made = std::make_shared<Material>();
        const auto slot = [&](const Texture& texture) {
            const glm::mat3 scale(glm::vec3(from.uv_scale.x, 0, 0), glm::vec3(0, from.uv_scale.y, 0),
                                  glm::vec3(0, 0, 1));
            return TextureSlot{.texture = texture, .uv_transform = scale};
        };
        made->id = new_asset_id();
        made->name = name;
        made->shading_model = from.shading_model;
        made->base_colour = glm::vec4(from.base_colour, from.opacity);
        made->metallic = from.metallic;
        made->roughness = from.roughness;
        made->normal_scale = from.normal_scale;
        made->occlusion_strength = from.occlusion_strength;
        made->emissive = from.emissive_cd_m2;
        made->alpha_mode = from.alpha_mode;
        made->alpha_cutoff = from.alpha_cutoff;
        made->double_sided = from.double_sided;
        made->ior = from.ior;
        made->specular = from.specular;
        made->specular_colour = from.specular_colour;
        made->transmission = from.transmission;
        made->thickness_m = from.thickness_m;
        made->attenuation_colour = from.attenuation_colour;
        made->attenuation_distance_m = from.attenuation_distance_m;
        made->diffuse_transmission = from.diffuse_transmission;
        made->diffuse_transmission_colour = from.diffuse_transmission_colour;
        made->base_colour_texture = slot(textures.base_colour);
        made->metallic_roughness_texture = slot(textures.metallic_roughness);
        made->normal_texture = slot(textures.normal);
        made->occlusion_texture = slot(textures.occlusion);
        made->emissive_texture = slot(textures.emissive);
        made->diffuse_transmission_texture = slot(textures.diffuse_transmission);
        made->diffuse_transmission_colour_texture = slot(textures.diffuse_transmission);
        return made;
    }

    std::map<EntityKey, Entry> entries_;
    std::shared_ptr<const Material> plain_;
};

/// The boundaries of interiors that scatter, made again only when the inside changed.
class Boundaries {
 public:
    /// The material that the surface is drawn with: its own where nothing scatters inside.
    std::shared_ptr<const Material> of(const ExtractContext& context, const Surface& surface) {
        if (!surface.interior || surface.interior->sigma_s_per_m == glm::vec3(0.0f)) return surface.material;
        const auto* component = context.world.find<InteriorComponent>(context.entity);
        const InteriorPaint paint = component ? component->paint : InteriorPaint{};
        const Key key{surface.interior->sigma_s_per_m,
                      surface.interior->sigma_a_per_m,
                      mean_cosine(surface.interior->phase),
                      surface.interior->eta,
                      surface.interior->roughness,
                      paint,
                      paint.texture.empty() ? nullptr : context.assets.texture(paint.texture, TextureUse::colour)};
        drop_dead(entries_, context.world);
        Entry& entry = entries_[key_of(context.entity)];
        if (!entry.material || entry.key != key) {
            entry.key = key;
            Material material = boundary_material(*surface.interior, context.world.name(context.entity));
            material.paint_cover = paint.cover;
            material.paint_colour = paint.colour;
            material.paint_texture.texture = key.paint_texture;
            entry.material = std::make_shared<const Material>(std::move(material));
        }
        return entry.material;
    }

 private:
    struct Key {
        glm::vec3 sigma_s{0.0f}, sigma_a{0.0f}, mean_cosine{0.0f};
        float eta = 0.0f, roughness = 0.0f;
        InteriorPaint paint;
        std::shared_ptr<const TextureAsset> paint_texture;
        bool operator==(const Key&) const = default;
    };
    struct Entry {
        Key key;
        std::shared_ptr<const Material> material;
    };
    std::map<EntityKey, Entry> entries_;
};

/// Meshes that are made rather than loaded: primitives and subdivided files, once for each set of parameters.
class MadeMeshes {
 public:
    std::shared_ptr<const MeshAsset> of(AssetStore& assets, const MeshComponent& from) {
        if (from.primitive != Primitive::none && !from.file.empty())
            throw Error("a mesh has a file or a primitive, not both");
        if (from.primitive != Primitive::none) return primitive(from.primitive, from.tessellation);
        if (from.file.empty()) throw Error("a mesh needs a file or a primitive");
        const std::shared_ptr<const MeshAsset> loaded = assets.mesh(from.file);
        return from.subdivision_levels == 0 ? loaded : subdivided(assets, *loaded, from);
    }

 private:
    std::shared_ptr<const MeshAsset> primitive(Primitive shape, int tessellation) {
        std::shared_ptr<const MeshAsset>& mesh = primitives_[{shape, tessellation}];
        if (!mesh)
            mesh = std::make_shared<MeshAsset>(
                MeshAsset{.id = new_asset_id(), .name = "primitive", .mesh = make_primitive(shape, tessellation)});
        return mesh;
    }

    std::shared_ptr<const MeshAsset> subdivided(AssetStore& assets, const MeshAsset& loaded,
                                                const MeshComponent& from) {
        Subdivided& made = subdivided_[{from.file, from.subdivision_levels}];
        if (!made.mesh || made.source != loaded.id) {  // a new id: the file was reloaded
            Mesh mesh = subdivide(load_polygons(assets.resolve(from.file)), from.subdivision_levels);
            compute_tangents(mesh);
            made.mesh = std::make_shared<MeshAsset>(
                MeshAsset{.id = new_asset_id(), .name = loaded.name, .mesh = std::move(mesh)});
            made.source = loaded.id;
        }
        return made.mesh;
    }

    struct Subdivided {
        uint64_t source = 0;
        std::shared_ptr<const MeshAsset> mesh;
    };
    std::map<std::pair<Primitive, int>, std::shared_ptr<const MeshAsset>> primitives_;
    std::map<std::pair<std::string, int>, Subdivided> subdivided_;
};

/// What is worked out once for a glTF file on an entity.
struct PlacedGltf {
    uint64_t id = 0;
    std::vector<std::string> excluded;
    std::vector<glm::mat4> to_root;  ///< of each node, relative to the entity
    std::vector<bool> casts_shadow;
    std::vector<GltfComponent::Glow> glow;
    std::map<std::pair<const Material*, const GltfComponent::Glow*>, std::shared_ptr<const Material>> glowing;

    void update(const GltfAsset& asset, const GltfComponent& component) {
        if (id == asset.id && excluded == component.cast_shadow_exclude && glow == component.glow) return;
        id = asset.id;
        excluded = component.cast_shadow_exclude;
        glow = component.glow;
        to_root.clear();
        casts_shadow.clear();
        glowing.clear();
        for (const GltfNode& node : asset.nodes) {
            const bool root = node.parent < 0;
            to_root.push_back(root ? node.local : to_root[static_cast<size_t>(node.parent)] * node.local);
            casts_shadow.push_back(std::ranges::none_of(
                excluded, [&](const std::string& pattern) { return matches_glob(pattern, node.name); }));
        }
    }

    /// A node's material with the emission that it has here.
    std::shared_ptr<const Material> material_of(const GltfNode& node, const std::shared_ptr<const Material>& plain) {
        const auto found = std::ranges::find_if(
            glow, [&](const GltfComponent::Glow& candidate) { return matches_glob(candidate.nodes, node.name); });
        if (found == glow.end() || plain->emissive == glm::vec3(0.0f)) return plain;
        std::shared_ptr<const Material>& made = glowing[{plain.get(), &*found}];
        if (!made) {
            Material material = *plain;
            material.id = new_asset_id();
            material.emissive *= found->factor;
            made = std::make_shared<const Material>(std::move(material));
        }
        return made;
    }
};

/// What is in a surface whose mesh, material and transform are there: what the entity's component says, or its
/// material.
std::optional<ScatteringInterior> interior_of(const ExtractContext& context, const Surface& surface, double time_s) {
    if (const auto* component = context.world.find<InteriorComponent>(context.entity))
        return make_interior(*component, context.assets, {surface.mesh->mesh.bounds, surface.transform, time_s});
    return interior_of_material(*surface.material);
}

/// An interior by itself is a mistake; meshes take theirs along.
void check_interior(const ExtractContext& context, const InteriorComponent&, RenderScene&) {
    if (!context.world.find<MeshComponent>(context.entity) && !context.world.find<GltfComponent>(context.entity))
        throw Error("an interior needs a mesh or a gltf on the same entity");
}

/// What the extractors of shapes share.
struct ShapeState {
    Materials materials;
    Boundaries boundaries;
    MadeMeshes meshes;
    std::map<EntityKey, PlacedGltf> placed;

    void extract_mesh(const ExtractContext& context, const MeshComponent& from, RenderScene& scene) {
        Surface surface;
        surface.mesh = meshes.of(context.assets, from);
        surface.material = materials.of(context);
        if (!surface.material) surface.material = materials.plain();
        surface.transform = context.transform;
        surface.previous_transform = context.previous_transform;
        surface.bounds = surface.mesh->mesh.bounds.transformed(context.transform);
        surface.casts_shadow = from.casts_shadow;
        surface.collides = collides(context.world, context.entity);
        surface.interior = interior_of(context, surface, scene.time_s);
        surface.material = boundaries.of(context, surface);
        surface.entity = context.entity;
        scene.surfaces.push_back(std::move(surface));
    }

    void extract_gltf(const ExtractContext& context, const GltfComponent& from, RenderScene& scene) {
        if (from.file.empty()) throw Error("a gltf needs a file");
        const std::shared_ptr<const GltfAsset> asset = context.assets.gltf(from.file);
        drop_dead(placed, context.world);
        PlacedGltf& place = placed[key_of(context.entity)];
        place.update(*asset, from);
        const std::shared_ptr<const Material> material = materials.of(context);
        const bool walls = collides(context.world, context.entity);
        for (size_t i = 0; i < asset->nodes.size(); ++i) {
            const GltfNode& node = asset->nodes[i];
            const glm::mat4 transform = context.transform * place.to_root[i];
            for (const GltfNode::Primitive& primitive : node.primitives) {
                Surface surface;
                surface.mesh = primitive.mesh;
                surface.material = material ? material : place.material_of(node, primitive.material);
                surface.transform = transform;
                surface.previous_transform = context.previous_transform * place.to_root[i];
                surface.bounds = primitive.mesh->mesh.bounds.transformed(transform);
                surface.casts_shadow = place.casts_shadow[i];
                surface.collides = walls;
                surface.interior = interior_of(context, surface, scene.time_s);
                surface.material = boundaries.of(context, surface);
                surface.entity = context.entity;
                scene.surfaces.push_back(std::move(surface));
            }
            if (node.light) add_placed(*node.light, transform, context.entity, scene.lights);
            if (node.camera) add_placed(*node.camera, transform, context.entity, scene.cameras);
        }
    }

    /// A file's light or camera with its node's place.
    template <class T>
    static void add_placed(T thing, const glm::mat4& transform, Entity entity, std::vector<T>& list) {
        thing.transform = rigid_transform(transform);
        thing.entity = entity;
        list.push_back(std::move(thing));
    }
};

}  // namespace

void add_shape_extractors(Extractors& extractors) {
    const auto state = std::make_shared<ShapeState>();
    add_extractor<MeshComponent>(extractors,
                                 [state](const ExtractContext& context, const MeshComponent& from, RenderScene& scene) {
                                     state->extract_mesh(context, from, scene);
                                 });
    add_extractor<GltfComponent>(extractors,
                                 [state](const ExtractContext& context, const GltfComponent& from, RenderScene& scene) {
                                     state->extract_gltf(context, from, scene);
                                 });
    add_extractor<InteriorComponent>(extractors, check_interior);
}

void register_engine_components(ComponentRegistry& registry, Extractors& extractors) {
    add_engine_components(registry);
    add_shape_extractors(extractors);
    add_light_extractors(extractors);
}

}  // namespace tyndall
