// Skin in the picture, with its place on the light map. Depths are those of render/shaders/surface.vert.
layout(location = 0) in vec3 position;
layout(location = 3) in vec2 uv0;

uniform mat4 world_from_local;
uniform mat4 clip_from_world;

out vec2 v_uv;
invariant gl_Position;

void main() {
    v_uv = uv0;
    vec4 world = world_from_local * vec4(position, 1.0);
    gl_Position = clip_from_world * world;
}
