// An object's own mesh, to reach the pixels where it is seen.
layout(location = 0) in vec3 position;

uniform mat4 world_from_local;
uniform mat4 clip_from_world;

void main() { gl_Position = clip_from_world * (world_from_local * vec4(position, 1.0)); }
