// An object as a light sees it (light_view.h).
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;

uniform mat4 world_from_local;
uniform mat3 normal_from_local;
uniform mat4 clip_from_world;

out vec3 v_place;
out vec3 v_normal;

void main() {
    v_place = (world_from_local * vec4(position, 1.0)).xyz;
    v_normal = normal_from_local * normal;
    gl_Position = clip_from_world * vec4(v_place, 1.0);
}
