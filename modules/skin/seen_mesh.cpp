#include "seen_mesh.h"

#include <epoxy/gl.h>

#include <glm/matrix.hpp>

#include "render/draw_state.h"
#include "render/gpu_scene.h"

namespace tyndall::skin {

void draw_seen_mesh(const gpu::Program& program, const Surface& surface, Frame& frame) {
    program.set("world_from_local", surface.transform);
    program.set("clip_from_world", frame.block.view_projection);
    const DrawState state(DepthState::equal);
    const bool mirrored = glm::determinant(glm::mat3(surface.transform)) < 0.0f;
    if (!surface.material->double_sided) glEnable(GL_CULL_FACE);
    glFrontFace(mirrored ? GL_CW : GL_CCW);
    frame.gpu_scene.draw_mesh(*surface.mesh);
    glDisable(GL_CULL_FACE);
    glFrontFace(GL_CCW);
}

}  // namespace tyndall::skin
