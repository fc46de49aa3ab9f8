// An object's mesh in the picture.
layout(location = 0) in vec3 position;
layout(location = 2) in vec3 scale;
layout(location = 3) in vec3 turn;

uniform mat4 world_from_body;
uniform mat4 clip_from_world;
uniform mat3 turn_to_world;

out vec3 v_scale;
out vec3 v_turn;

void main() {
    v_scale = scale;
    v_turn = turn_to_world * turn;
    gl_Position = clip_from_world * (world_from_body * vec4(position, 1.0));
}
