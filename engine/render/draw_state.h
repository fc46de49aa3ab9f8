#pragma once
/// GL's drawing state for the time of a scope.

#include <epoxy/gl.h>

namespace tyndall {

/// What happens with the depth target that is bound, in reversed-Z.
enum class DepthState {
    off,
    write,    ///< nearest wins
    equal,    ///< only where the same surface was drawn before
    in_front  ///< only where what is drawn lies behind the stored depth: inside of a volume whose back faces are drawn
};

enum class BlendState {
    off,
    add,           ///< target + source
    attenuate_add  ///< target * source 1 + source 0 (dual source)
};

/// Sets the state and puts GL's defaults back at the end of the scope.
class DrawState {
 public:
    explicit DrawState(DepthState depth, BlendState blend = BlendState::off) {
        if (depth != DepthState::off) {
            glEnable(GL_DEPTH_TEST);
            glDepthMask(depth == DepthState::write ? GL_TRUE : GL_FALSE);
            glDepthFunc(depth == DepthState::write ? GL_GREATER : depth == DepthState::equal ? GL_EQUAL : GL_LESS);
        }
        if (blend != BlendState::off) {
            glEnable(GL_BLEND);
            glBlendFunc(GL_ONE, blend == BlendState::add ? GL_ONE : GL_SRC1_COLOR);
        }
    }
    ~DrawState() {
        glDisable(GL_DEPTH_TEST);
        glDepthMask(GL_TRUE);
        glDisable(GL_BLEND);
    }
    DrawState(const DrawState&) = delete;
    DrawState& operator=(const DrawState&) = delete;
};

}  // namespace tyndall
