// The drawn mesh, with the points' light that was blended at its vertices.
layout(location = 0) in vec3 position;

uniform sampler2D vertex_light;  // as blend.comp writes it
uniform mat4 world_from_local;
uniform mat4 clip_from_world;

const uint kColumns = 256u;

out vec4 v_others;  // a: share from deep inside
out vec3 v_own;

void main() {
    gl_Position = clip_from_world * (world_from_local * vec4(position, 1.0));
    uint first = 2u * uint(gl_VertexID);
    ivec2 texel = ivec2(first % kColumns, first / kColumns);  // the other is beside it
    v_others = texelFetch(vertex_light, texel, 0);
    v_own = texelFetch(vertex_light, texel + ivec2(1, 0), 0).rgb;
}
