#pragma once
/// What passes keep between frames, until it has not been asked for in some frames.

#include <cstdint>
#include <map>
#include <tuple>

#include "scene/render_scene.h"

namespace tyndall {

/// Values by a key. References to them stay good until they are forgotten.
template <class Key, class T>
class Kept {
 public:
    /// Made when it is not there.
    T& at(const Key& key) {
        Entry& entry = entries_[key];
        entry.last_used = frame_;
        return entry.value;
    }
    /// Whether `at` has been called with the key in this frame.
    [[nodiscard]] bool used(const Key& key) const {
        const auto found = entries_.find(key);
        return found != entries_.end() && found->second.last_used == frame_;
    }
    /// Frames that have ended, and this one.
    [[nodiscard]] uint64_t frame() const { return frame_; }
    /// Forgets what nobody uses.
    void end_frame() {
        constexpr uint64_t kKeptFrames = 120;
        std::erase_if(entries_, [&](const auto& entry) { return entry.second.last_used + kKeptFrames < frame_; });
        ++frame_;
    }

 private:
    struct Entry {
        T value;
        uint64_t last_used = 0;
    };
    std::map<Key, Entry> entries_;
    uint64_t frame_ = 1;
};

/// A value for each surface that a pass renders. A glTF has one mesh many times under one entity: they are told apart
/// by the order in which they come in a frame.
template <class T>
class KeptOfSurfaces {
 public:
    /// To be called once a surface and frame.
    T& of(const Surface& surface) {
        Key key{uint64_t(surface.entity.index) << 32u | surface.entity.generation, surface.mesh->id, 0};
        while (kept_.used(key)) ++std::get<2>(key);
        return kept_.at(key);
    }
    [[nodiscard]] uint64_t frame() const { return kept_.frame(); }
    void end_frame() { kept_.end_frame(); }

 private:
    using Key = std::tuple<uint64_t, uint64_t, int>;  ///< entity, mesh, how many of both came before
    Kept<Key, T> kept_;
};

}  // namespace tyndall
