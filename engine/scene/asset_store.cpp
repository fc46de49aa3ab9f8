#include "scene/asset_store.h"

#include <algorithm>
#include <array>
#include <map>
#include <unordered_map>

#include "color/color.h"
#include "core/error.h"
#include "core/file_watch.h"
#include "core/log.h"
#include "core/paths.h"
#include "scene/gltf_import.h"
#include "scene/phase_table.h"
#include "scene/texture_loading.h"

namespace tyndall {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kProjectAssets = "assets:";

/// Whether the extractors' users hold the asset, or anything in it.
template <class Asset>
bool held_elsewhere(const std::shared_ptr<const Asset>& asset) {
    return asset.use_count() > 1;
}

template <>
bool held_elsewhere(const std::shared_ptr<const GltfAsset>& asset) {
    if (asset.use_count() > 1) return true;
    std::unordered_map<const void*, long> inside;  // how often each mesh and material hangs on the asset's own nodes
    const auto count = [&](const auto& visit) {
        for (const GltfNode& node : asset->nodes)
            for (const GltfNode::Primitive& primitive : node.primitives) {
                visit(primitive.mesh);
                visit(primitive.material);
            }
    };
    bool held = false;
    count([&](const auto& part) { ++inside[part.get()]; });
    count([&](const auto& part) { held = held || part.use_count() > inside[part.get()]; });
    return held;
}

/// Assets of one kind: by the file they come from, and by the names that were asked for.
template <class Asset>
class Cache {
 public:
    /// Loads from a file; adds every file that it reads, also when it throws.
    using Load = std::function<Asset(const fs::path& file, std::string_view name, std::vector<fs::path>& sources)>;

    explicit Cache(Load load) : load_(std::move(load)) {}

    /// What `name` was last found to be; null when it was not asked for yet. Throws the Error that loading it threw.
    std::shared_ptr<const Asset> find(std::string_view name) const {
        const auto found = names_.find(name);
        return found == names_.end() ? nullptr : found->second->get();
    }

    std::shared_ptr<const Asset> load(std::string_view name, const fs::path& file, FileWatch& watch) {
        const auto [entry, is_new] = entries_.try_emplace(file);
        if (is_new) {
            entry->second.name = name;
            read(file, entry->second, watch);
        }
        names_.emplace(name, &entry->second);
        return entry->second.get();
    }

    /// Names mean other files from now on.
    void forget_names() { names_.clear(); }

    bool reload(const std::vector<fs::path>& changed, FileWatch& watch) {
        bool any = false;
        for (auto entry = entries_.begin(); entry != entries_.end();) {
            const auto here = entry++;
            if (!reads_one_of(here->second, changed)) continue;
            if (here->second.asset)
                any = read(here->first, here->second, watch) || any;
            else {
                any = true;  // was broken: tried anew when somebody asks
                erase(here);
            }
        }
        return any;
    }

    void collect() {
        for (auto entry = entries_.begin(); entry != entries_.end();) {
            const auto here = entry++;
            if (!here->second.asset || !held_elsewhere(here->second.asset)) erase(here);
        }
    }

    void add_sources(std::vector<fs::path>& all) const {
        for (const auto& [file, entry] : entries_) all.insert(all.end(), entry.sources.begin(), entry.sources.end());
    }

 private:
    struct Entry {
        std::string name;
        std::shared_ptr<const Asset> asset;  ///< the last good one
        std::vector<fs::path> sources;
        std::optional<Error> error;  ///< why there is no asset

        [[nodiscard]] std::shared_ptr<const Asset> get() const {
            if (!asset && error) throw Error(*error);
            return asset;
        }
    };
    using Entries = std::map<fs::path, Entry>;

    static bool reads_one_of(const Entry& entry, const std::vector<fs::path>& changed) {
        return std::ranges::any_of(entry.sources,
                                   [&](const fs::path& file) { return std::ranges::binary_search(changed, file); });
    }

    /// True when there is a new asset. Where loading fails, an older one stays.
    bool read(const fs::path& file, Entry& entry, FileWatch& watch) {
        watch.add(file);  // before it is read: a change meanwhile is one more change
        std::vector<fs::path> sources{file};
        bool loaded = true;
        try {
            entry.asset = std::make_shared<const Asset>(load_(file, entry.name, sources));
            entry.error.reset();
        } catch (const Error& error) {
            loaded = false;
            if (entry.asset)
                log::error("{}\n  the one that was loaded before stays in use", error.what());
            else
                entry.error = error;
        }
        for (const fs::path& source : sources) watch.add(source);
        entry.sources = std::move(sources);
        return loaded;
    }

    void erase(typename Entries::iterator entry) {
        std::erase_if(names_, [&](const auto& name) { return name.second == &entry->second; });
        entries_.erase(entry);
    }

    Load load_;
    Entries entries_;
    std::map<std::string, Entry*, std::less<>> names_;
};

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

    Cache<VolumeAsset>& volumes_of(std::string_view grid) {
        const auto found = volumes.find(grid);
        if (found != volumes.end()) return found->second;
        const auto load = [grid = std::string(grid)](const fs::path& file, std::string_view name,
                                                     std::vector<fs::path>& sources) {
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
    std::map<std::string, Cache<VolumeAsset>, std::less<>> volumes;  ///< one for each name of a grid
    Cache<PhaseTable> phase_tables{
        [](const fs::path& file, std::string_view name, auto&) { return load_phase_table(file, name); }};
};

AssetStore::AssetStore(const ColorConfig& config, fs::path base)
    : self_(std::make_unique<Implementation>(config, std::move(base))) {}
AssetStore::~AssetStore() = default;

void AssetStore::set_base(fs::path base) {
    if (base == self_->base) return;
    self_->base = std::move(base);
    self_->missing.clear();
    self_->each([](auto& cache) { cache.forget_names(); });
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

std::shared_ptr<const VolumeAsset> AssetStore::volume(std::string_view name, std::string_view grid) {
    return self_->get(self_->volumes_of(grid.empty() ? kDefaultGrid : grid), name);
}

std::shared_ptr<const PhaseTable> AssetStore::phase_table(std::string_view name) {
    return self_->get(self_->phase_tables, name);
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
    const std::vector<fs::path> after = files();
    for (const fs::path& file : before)
        if (!std::ranges::binary_search(after, file)) self_->watch.remove(file);
}

}  // namespace tyndall
