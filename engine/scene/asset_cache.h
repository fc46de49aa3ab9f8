#pragma once
// The cache behind the asset store, for its source.

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/error.h"
#include "core/file_watch.h"
#include "core/log.h"
#include "scene/asset_store.h"

namespace tyndall {

/// Whether the extractors' users hold the asset, or anything in it.
template <class Asset>
bool held_elsewhere(const std::shared_ptr<const Asset>& asset) {
    return asset.use_count() > 1;
}

template <>
inline bool held_elsewhere(const std::shared_ptr<const GltfAsset>& asset) {
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
    using Load = std::function<Asset(const std::filesystem::path& file, std::string_view name,
                                     std::vector<std::filesystem::path>& sources)>;

    explicit Cache(Load load) : load_(std::move(load)) {}

    /// What `name` was last found to be; null when it was not asked for yet. Throws the Error that loading it threw.
    std::shared_ptr<const Asset> find(std::string_view name) const {
        const auto found = names_.find(name);
        return found == names_.end() ? nullptr : found->second->get();
    }

    std::shared_ptr<const Asset> load(std::string_view name, const std::filesystem::path& file, FileWatch& watch) {
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

    bool reload(const std::vector<std::filesystem::path>& changed, FileWatch& watch) {
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

    void add_sources(std::vector<std::filesystem::path>& all) const {
        for (const auto& [file, entry] : entries_) all.insert(all.end(), entry.sources.begin(), entry.sources.end());
    }

 private:
    struct Entry {
        std::string name;
        std::shared_ptr<const Asset> asset;  ///< the last good one
        std::vector<std::filesystem::path> sources;
        std::optional<Error> error;  ///< why there is no asset

        [[nodiscard]] std::shared_ptr<const Asset> get() const {
            if (!asset && error) throw Error(*error);
            return asset;
        }
    };
    using Entries = std::map<std::filesystem::path, Entry>;

    static bool reads_one_of(const Entry& entry, const std::vector<std::filesystem::path>& changed) {
        return std::ranges::any_of(entry.sources, [&](const std::filesystem::path& file) {
            return std::ranges::binary_search(changed, file);
        });
    }

    /// True when there is a new asset. Where loading fails, an older one stays.
    bool read(const std::filesystem::path& file, Entry& entry, FileWatch& watch) {
        watch.add(file);  // before it is read: a change meanwhile is one more change
        std::vector<std::filesystem::path> sources{file};
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
        for (const std::filesystem::path& source : sources) watch.add(source);
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

}  // namespace tyndall
