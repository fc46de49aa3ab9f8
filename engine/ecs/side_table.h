#pragma once
/// What only some entities have, kept apart from those that have it not.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

namespace tyndall::detail {

/// Values by entity index. An index without a value costs at most four bytes; values keep their address.
template <class T>
class SideTable {
 public:
    [[nodiscard]] T* find(uint32_t index) {
        return index < place_.size() && place_[index] != kNone ? &values_[place_[index]] : nullptr;
    }
    [[nodiscard]] const T* find(uint32_t index) const { return const_cast<SideTable*>(this)->find(index); }

    /// The value of that index, default-constructed when there is none.
    T& obtain(uint32_t index) {
        if (index >= place_.size()) place_.resize(index + size_t{1}, kNone);
        uint32_t& place = place_[index];
        if (place == kNone && !free_.empty()) {
            place = free_.back();
            free_.pop_back();
        } else if (place == kNone) {
            values_.emplace_back();
            place = static_cast<uint32_t>(values_.size() - 1);
        }
        return values_[place];
    }

    void erase(uint32_t index) {
        T* value = find(index);
        if (value == nullptr) return;
        free_.push_back(place_[index]);
        *value = T();
        place_[index] = kNone;
    }

 private:
    static constexpr uint32_t kNone = 0xffffffff;
    std::vector<uint32_t> place_;  ///< by entity index: where in values_
    std::deque<T> values_;
    std::vector<uint32_t> free_;
};

}  // namespace tyndall::detail
