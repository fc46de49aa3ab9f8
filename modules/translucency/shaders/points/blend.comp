// Blends the points' light at the drawn mesh's vertices.
layout(local_size_x = 64) in;

uniform sampler2D blends;       // a vertex's four points: 256 times the number, and the weight
uniform sampler2D point_light;  // as store.glsl writes it
layout(rgba32f) writeonly uniform image2D vertex_light;  // likewise
uniform uint vertices;

const uint kColumns = 256u;
ivec2 texel_at(uint i) { return ivec2(i % kColumns, i / kColumns); }

void main() {
    uint vertex = gl_GlobalInvocationID.x;
    if (vertex >= vertices) return;
    uvec4 both = uvec4(texelFetch(blends, texel_at(vertex), 0));
    uvec4 points = both >> 8u;
    vec4 weights = vec4(both & 255u);
    weights /= max(dot(weights, vec4(1.0)), 1e-6);
    vec4 others = vec4(0.0), own = vec4(0.0);
    for (uint i = 0u; i < 4u; ++i) {
        ivec2 texel = texel_at(2u * points[i]);  // the other is beside it
        others += weights[i] * texelFetch(point_light, texel, 0);
        own += weights[i] * texelFetch(point_light, texel + ivec2(1, 0), 0);
    }
    imageStore(vertex_light, texel_at(2u * vertex), others);
    imageStore(vertex_light, texel_at(2u * vertex + 1u), own);
}
