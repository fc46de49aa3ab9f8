// The border between lit and dark space.
#include "render/shaders/frame.glsl"

layout(location = 0) in vec3 position;

out vec3 from_eye;
invariant gl_Position;

void main() {
    from_eye = position - frame.eye_near.xyz;
    gl_Position = frame.view_projection * vec4(position, 1.0);
}
