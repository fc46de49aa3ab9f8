// An object's mesh in the picture.
layout(location = 0) in vec3 position;
layout(location = 3) in vec3 own;
layout(location = 4) in vec3 others;
layout(location = 5) in vec3 sizes;

uniform mat4 world_from_body;
uniform mat4 clip_from_world;
uniform mat3 normals_to_world;

out vec3 v_own;
out vec3 v_others;
out vec3 v_sizes;

void main() {
    v_own = own;
    v_others = normals_to_world * others;
    v_sizes = sizes;
    gl_Position = clip_from_world * (world_from_body * vec4(position, 1.0));
}
