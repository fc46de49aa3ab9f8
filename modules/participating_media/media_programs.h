#pragma once
/// Programs that look at media, compiled for what is known of them (shaders/media.glsl).

#include <array>
#include <compare>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "media_buffer.h"
#include "render/frame_graph.h"
#include "render/light_programs.h"

namespace tyndall::participating_media {

/// PHASE_KIND when the phase function is known.
[[nodiscard]] std::vector<std::string> phase_defines(std::optional<PhaseKind> phase);

/// Sets what shaders/light_source.glsl declares, but for the light and the medium.
void bind_light_source(const gpu::Program& program, PassContext& context, const MediaBuffer& media, int light_steps);

/// A program's variants: by the phase function, and by numbers that the program has as defines of its own.
class MediaPrograms {
 public:
    /// `base` is completed by the defines; `numbers` are the names of those that `of` is given.
    explicit MediaPrograms(gpu::ProgramDesc base, std::vector<std::string> numbers = {})
        : base_(std::move(base)), numbers_(std::move(numbers)) {}

    /// Before a pass's first light, and after any other program was used: nothing is in use.
    void begin() { last_ = nullptr; }
    /// `values`: at most two, as many as there are names.
    [[nodiscard]] LightPrograms& of(std::optional<PhaseKind> phase, std::array<int, 2> values = {});

 private:
    struct Key {
        std::optional<PhaseKind> phase;
        std::array<int, 2> values{};
        auto operator<=>(const Key&) const = default;
    };
    gpu::ProgramDesc base_;
    std::vector<std::string> numbers_;
    std::map<Key, LightPrograms> programs_;
    LightPrograms* last_ = nullptr;
};

}  // namespace tyndall::participating_media
