// An object as a camera or a light sees it.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 scale;

uniform mat4 clip_from_body;

out vec3 v_place;
out vec3 v_normal;
out vec3 v_scale;

void main() {
    v_place = position;
    v_normal = normal;
    v_scale = scale;
    gl_Position = clip_from_body * vec4(position, 1.0);
}
