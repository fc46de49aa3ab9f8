// Skin in the picture, with its place on the light map.
layout(location = 0) in vec3 position;
layout(location = 3) in vec2 uv0;

uniform mat4 world_from_local;
uniform mat4 clip_from_world;

out vec2 v_uv;

void main() {
    v_uv = uv0;
    gl_Position = clip_from_world * (world_from_local * vec4(position, 1.0));
}
