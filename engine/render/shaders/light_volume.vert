// A light's volume; its back faces are drawn.
layout(location = 0) in vec3 position;

uniform mat4 clip_from_volume;

void main() { gl_Position = clip_from_volume * vec4(position, 1.0); }
