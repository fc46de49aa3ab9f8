#pragma once
/// How a component is written in a scene file where that is more than its plain fields: presets for any component, and
/// for transforms "look_at" and a single number for "scale".

#include <glm/mat4x4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ecs/transform.h"
#include "scene/field_reader.h"
#include "scene/text_patch.h"

namespace tyndall {

/// The key that names a preset: config/presets/COMPONENT/NAME.json holds fields, those given beside the key override.
inline constexpr std::string_view kPresetKey = "preset";
/// Says in a preset where its numbers come from; read by people only.
inline constexpr std::string_view kDocKey = "doc";

/// The names of a component's presets, sorted; empty when it has none.
[[nodiscard]] std::vector<std::string> preset_names(std::string_view component);

/// Whether scene files may hold the component: not what the engine makes itself ("world_matrix", "transient").
[[nodiscard]] bool is_authored(std::string_view component);

/// What a component's text says beside the values of its fields.
struct ComponentForm {
    std::optional<glm::vec3> look_at;  ///< of a transform: the point in the world that local -Z faces
};

/// Reads a component with its preset and special forms over the values in `object`.
ComponentForm read_component(const StructType& type, void* object, const JsonValue& json, Problems& problems,
                             std::string* unknown = nullptr);

/// The rotation relative to the parent that turns local -Z to `target` (world, metres) and +Y as near to the world's +Y
/// as can be; the last upright one still defined when looking straight up or down. Identity when the target is the
/// position itself or the parent's matrix has no inverse.
[[nodiscard]] glm::quat look_at_rotation(const glm::mat4& parent, const glm::vec3& translation,
                                         const glm::vec3& target);
/// The product of the transforms above an entity.
[[nodiscard]] glm::mat4 parent_matrix(const World& world, Entity entity);

/// Adds to `patch` what makes the text of a component say `now`. `base` is what it says so far (for a "look_at", with
/// the rotation that it would give).
void patch_component(TextPatch& patch, const StructType& type, const void* base, const void* now,
                     const JsonValue& json);

}  // namespace tyndall
