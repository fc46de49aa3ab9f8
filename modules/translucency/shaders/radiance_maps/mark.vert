// An object's mesh in the picture.
layout(location = 0) in vec3 position;
layout(location = 2) in vec3 colour;

uniform mat4 world_from_body;
uniform mat4 clip_from_world;

out vec3 v_scale;

void main() {
    v_scale = colour;
    gl_Position = clip_from_world * (world_from_body * vec4(position, 1.0));
}
