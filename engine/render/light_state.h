#pragma once
/// What the light that arrives at an object depends on.

#include <cstdint>
#include <string>
#include <type_traits>

namespace tyndall {

struct Frame;
struct RenderScene;

/// Appends a value's bytes: equal strings mean that nothing has changed.
template <class T>
void append_state(std::string& state, const T& value) {
    static_assert(std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>);
    state.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// A light, its gobo, its shadow maps; with media in the air also the frame, since they change as they like.
void append_light_state(std::string& state, const Frame& frame, size_t light, uint64_t frame_number);

/// Whether surfaces get diffuse light from elsewhere than from lights: probes and the sky, unless they are turned into
/// lights.
[[nodiscard]] bool has_light_all_around(const RenderScene& scene);
/// Whether anything is to be seen all around: probes and the sky, for what mirrors or is clear.
[[nodiscard]] bool has_surroundings(const RenderScene& scene);

/// Light that comes from no light source: probes and the sky; where anything else provides some, also the frame.
void append_surroundings_state(std::string& state, const Frame& frame, uint64_t frame_number);

}  // namespace tyndall
