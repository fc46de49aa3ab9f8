// An object seen from a light.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;

uniform mat4 world_from_local;
uniform mat3 normal_from_local;
uniform mat4 clip_from_world;
uniform mat4 view_from_world;

out vec4 v_normal_z;

void main() {
    vec4 world = world_from_local * vec4(position, 1.0);
    gl_Position = clip_from_world * world;
    v_normal_z = vec4(normal_from_local * normal, (view_from_world * world).z);
}
