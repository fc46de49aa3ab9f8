#include "ecs/names.h"

#include <utility>

namespace tyndall::detail {

void Names::set(uint32_t index, std::string name) {
    if (const std::string* old = names_.find(index)) {
        const auto bearers = indices_.find(*old);
        bearers->second.erase(index);
        if (bearers->second.empty()) indices_.erase(bearers);
        names_.erase(index);
    }
    if (name.empty()) return;
    indices_[name].insert(index);
    names_.obtain(index) = std::move(name);
}

const std::string& Names::of(uint32_t index) const {
    static const std::string none;
    const std::string* name = names_.find(index);
    return name ? *name : none;
}

uint32_t Names::find(std::string_view name) const {
    const auto bearers = indices_.find(name);
    return bearers == indices_.end() ? 0xffffffff : *bearers->second.begin();
}

}  // namespace tyndall::detail
