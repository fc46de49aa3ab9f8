#pragma once
/// The names of entities, and finding an entity by its name.

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "ecs/side_table.h"

namespace tyndall::detail {

/// Names by entity index. Several entities may share a name.
class Names {
 public:
    /// An empty name is none.
    void set(uint32_t index, std::string name);
    void erase(uint32_t index) {
        if (names_.find(index) != nullptr) set(index, {});
    }
    [[nodiscard]] const std::string& of(uint32_t index) const;
    /// The lowest index of that name, or 0xffffffff.
    [[nodiscard]] uint32_t find(std::string_view name) const;

 private:
    SideTable<std::string> names_;
    std::map<std::string, std::set<uint32_t>, std::less<>> indices_;
};

}  // namespace tyndall::detail
