// Skin in the picture once more, with its place on maps. Depths are those of render/shaders/surface.vert.
layout(location = 0) in vec3 position;
layout(location = 3) in vec2 uv0;

uniform mat4 world_from_local;
uniform mat4 clip_from_world;

out vec2 v_uv;
invariant gl_Position;
#ifdef VERTEX_THICKNESS
uniform sampler2D thicknesses;  // of the mesh's vertices, row after row
uniform float metres;           // that 1 of them stands for
out float v_thickness;
#endif

void main() {
    v_uv = uv0;
    vec4 world = world_from_local * vec4(position, 1.0);
    gl_Position = clip_from_world * world;
#ifdef VERTEX_THICKNESS
    int columns = textureSize(thicknesses, 0).x;
    v_thickness = metres * texelFetch(thicknesses, ivec2(gl_VertexID % columns, gl_VertexID / columns), 0).x;
#endif
}
