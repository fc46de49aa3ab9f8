#include "reference/textures.h"

#include "physics/physics.h"
#include "scene/texture_lookup.h"

namespace tyndall::reference {

glm::vec4 sample_slot(const TextureSlot& slot, const SurfacePoint& point) {
    if (!slot.texture) return glm::vec4(1.0f);
    const glm::vec3 uv = slot.uv_transform * glm::vec3(point.uv[slot.uv_set == 1 ? 1 : 0], 1.0f);
    return sample_texture(*slot.texture, glm::vec2(uv), slot.texture->wrap_u, slot.texture->wrap_v);
}

glm::vec3 sample_equirect(const TextureAsset& texture, const glm::vec3& direction) {
    const glm::vec4 value =
        sample_texture(texture, physics::direction_to_equirect(direction), TextureWrap::repeat, TextureWrap::clamp);
    return texture.image.channels < 3 ? glm::vec3(value.x) : glm::vec3(value);
}

}  // namespace tyndall::reference
