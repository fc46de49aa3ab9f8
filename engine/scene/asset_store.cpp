#include "scene/asset_store.h"

#include <algorithm>
#include <array>
#include <map>

#include "color/color.h"
#include "core/paths.h"
#include "scene/asset_cache.h"
#include "scene/gltf_import.h"
#include "scene/made_volumes.h"
#include "scene/mesh_mask.h"
#include "scene/phase_table.h"
#include "scene/texture_loading.h"
#include "scene/volume_stream.h"

namespace tyndall {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kProjectAssets = "assets:";

}  // namespace

struct AssetStore::Implementation {
    Implementation(const ColorConfig& color, fs::path folder)
        : config(color),
          base(std::move(folder)),
          textures{textures_for(TextureUse::colour), textures_for(TextureUse::data), textures_for(TextureUse::probe)} {}

    Cache<TextureAsset> textures_for(TextureUse use) {
        return Cache<TextureAsset>([this, use](const fs::path& file, std::string_view name, auto&) {
            return load_texture(file, name, use, config);
        });
    }

    Cache<VolumeAsset>& volumes_of(const GridChoice& grid) {
        const auto found = volumes.find(grid);
        if (found != volumes.end()) return found->second;
        const auto load = [grid](const fs::path& file, std::string_view name, std::vector<fs::path>& sources) {
            return VolumeAsset{
                .id = new_asset_id(), .name = std::string(name), .volume = load_volume(file, grid, &sources)};
        };
        return volumes.emplace(grid, Cache<VolumeAsset>(load)).first->second;
    }

    /// Calls `visit` with every cache.
    template <class Visit>
    void each(Visit visit) {
        visit(meshes);
        visit(gltfs);
        visit(phase_tables);
        visit(particle_sets);
        for (auto& cache : textures) visit(cache);
        for (auto& cache : volumes) visit(cache.second);
    }

    template <class Asset>
    std::shared_ptr<const Asset> get(Cache<Asset>& cache, std::string_view name) {
        if (auto found = cache.find(name)) return found;
        return cache.load(name, locate(name), watch);
    }

    /// As resolve(), but remembers what is not there, so that a frame that asks again does not search the disk again.
    fs::path locate(std::string_view name) {
        if (const auto known = missing.find(name); known != missing.end()) throw Error(known->second.error);
        try {
            return resolve(name);
        } catch (const Error& error) {
            const auto [folder, rest] = split(name);
            Missing entry{(folder / rest).lexically_normal(), error};
            watch.add(entry.file);
            missing.emplace(name, std::move(entry));
            throw;
        }
    }

    /// The folder that a name is relative to, and the rest of the name.
    [[nodiscard]] std::pair<fs::path, std::string_view> split(std::string_view name) const {
        if (name.starts_with(kProjectAssets)) return {paths::root() / "assets", name.substr(kProjectAssets.size())};
        return {base, name};
    }
    [[nodiscard]] fs::path resolve(std::string_view name) const {
        const auto [folder, rest] = split(name);
        return paths::resolve_asset(folder, rest);
    }
    /// A name that led to no file, and where the file would be.
    struct Missing {
        fs::path file;
        Error error;
    };

    const ColorConfig& config;
    fs::path base;
    FileWatch watch;
    std::map<std::string, Missing, std::less<>> missing;
    Cache<MeshAsset> meshes{[](const fs::path& file, std::string_view name, auto&) {
        return MeshAsset{.id = new_asset_id(), .name = std::string(name), .mesh = load_mesh(file)};
    }};
    std::array<Cache<TextureAsset>, 3> textures;  ///< one for each TextureUse
    Cache<GltfAsset> gltfs{[this](const fs::path& file, std::string_view name, std::vector<fs::path>& sources) {
        return import_gltf(file, name, config, sources);
    }};
    std::map<GridChoice, Cache<VolumeAsset>> volumes;
    Cache<PhaseTable> phase_tables{
        [](const fs::path& file, std::string_view name, auto&) { return load_phase_table(file, name); }};
    Cache<ParticleAsset> particle_sets{[](const fs::path& file, std::string_view name, auto&) {
        return ParticleAsset{.id = new_asset_id(), .name = std::string(name), .particles = load_particles(file)};
    }};
    MadeVolumes made;
    VolumeStream stream;
    bool streaming = false;
};

AssetStore::AssetStore(const ColorConfig& config, fs::path base)
    : self_(std::make_unique<Implementation>(config, std::move(base))) {}
AssetStore::~AssetStore() = default;

void AssetStore::set_base(fs::path base) {
    if (base == self_->base) return;
    self_->base = std::move(base);
    self_->missing.clear();
    self_->each([](auto& cache) { cache.forget_names(); });
    self_->stream.clear();
}

fs::path AssetStore::resolve(std::string_view name) const {
    return self_->resolve(name);
}

std::shared_ptr<const MeshAsset> AssetStore::mesh(std::string_view name) {
    return self_->get(self_->meshes, name);
}

std::shared_ptr<const TextureAsset> AssetStore::texture(std::string_view name, TextureUse use) {
    return self_->get(self_->textures.at(static_cast<size_t>(use)), name);
}

std::shared_ptr<const GltfAsset> AssetStore::gltf(std::string_view name) {
    return self_->get(self_->gltfs, name);
}

std::shared_ptr<const VolumeAsset> AssetStore::volume(std::string_view name, const GridChoice& grid) {
    GridChoice named = grid;
    if (named.name.empty()) named.name = kDefaultGrid;
    return self_->get(self_->volumes_of(named), name);
}

std::shared_ptr<const PhaseTable> AssetStore::phase_table(std::string_view name) {
    return self_->get(self_->phase_tables, name);
}

std::shared_ptr<const ParticleAsset> AssetStore::particles(std::string_view name) {
    return self_->get(self_->particle_sets, name);
}

std::shared_ptr<const VolumeAsset> AssetStore::mesh_mask(const MeshAsset& mesh, int resolution) {
    return self_->made.get("mesh " + std::to_string(mesh.id) + " at " + std::to_string(resolution), [&] {
        return VolumeAsset{new_asset_id(), mesh.name, voxelised(mesh.mesh, resolution, mesh.name)};
    });
}

std::shared_ptr<const VolumeAsset> AssetStore::particle_mask(std::span<const Particle> particles, int resolution) {
    std::string key = "particles at " + std::to_string(resolution) + ": ";
    key.append(reinterpret_cast<const char*>(particles.data()), particles.size_bytes());
    return self_->made.get(std::move(key), [&] {
        return VolumeAsset{new_asset_id(), "particles", rasterised(particles, resolution)};
    });
}

std::shared_ptr<const VolumeAsset> AssetStore::sequence_frame(const VolumeSequence& sequence, int index) {
    const auto load = [this](const VolumeFrame& frame) -> VolumeStream::Source {
        return {frame, self_->resolve(frame.name)};
    };
    return self_->stream.frame(sequence, index, load, !self_->streaming);
}

void AssetStore::set_streaming(bool on) {
    self_->streaming = on;
}

bool AssetStore::reload_changed() {
    const std::vector<fs::path> changed = self_->watch.changed();
    if (changed.empty()) return false;
    bool any = std::erase_if(self_->missing, [&](const auto& entry) {
                   return std::ranges::binary_search(changed, entry.second.file);
               }) > 0;
    self_->each([&](auto& cache) { any = cache.reload(changed, self_->watch) || any; });
    return any;
}

std::vector<fs::path> AssetStore::files() const {
    std::vector<fs::path> all;
    self_->each([&](const auto& cache) { cache.add_sources(all); });
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

void AssetStore::collect() {
    const std::vector<fs::path> before = files();
    self_->each([](auto& cache) { cache.collect(); });
    self_->made.collect();
    const std::vector<fs::path> after = files();
    for (const fs::path& file : before)
        if (!std::ranges::binary_search(after, file)) self_->watch.remove(file);
}

}  // namespace tyndall
