#pragma once
/// Volumes that are worked out once from other assets.

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "core/error.h"
#include "core/function_ref.h"
#include "scene/render_scene.h"

namespace tyndall {

/// Keeps what was made, and why something could not be.
class MadeVolumes {
 public:
    /// The volume of this name; calls `make` the first time. Throws the Error that it threw.
    [[nodiscard]] std::shared_ptr<const VolumeAsset> get(std::string key, FunctionRef<VolumeAsset()> make);
    /// Forgets what nobody else holds, and errors.
    void collect();

 private:
    struct Entry {
        std::shared_ptr<const VolumeAsset> asset;
        std::optional<Error> error;
    };
    std::map<std::string, Entry, std::less<>> entries_;
};

}  // namespace tyndall
