#include "scene/made_volumes.h"

namespace tyndall {

std::shared_ptr<const VolumeAsset> MadeVolumes::get(std::string key, FunctionRef<VolumeAsset()> make) {
    const auto [found, is_new] = entries_.try_emplace(std::move(key));
    Entry& entry = found->second;
    if (is_new) {
        try {
            entry.asset = std::make_shared<const VolumeAsset>(make());
        } catch (const Error& error) {
            entry.error = error;
        }
    }
    if (entry.error) throw Error(*entry.error);
    return entry.asset;
}

void MadeVolumes::collect() {
    std::erase_if(entries_,
                  [](const auto& entry) { return !entry.second.asset || entry.second.asset.use_count() == 1; });
}

}  // namespace tyndall
