// Blends the points' light over the drawn mesh.
layout(location = 0) in vec3 position;
layout(location = 1) in uvec2 points;  // four of 16 bits
layout(location = 2) in vec4 weights;

uniform sampler2D point_light;  // as store.glsl writes it
uniform mat4 world_from_local;
uniform mat4 clip_from_world;

const uint kColumns = 256u;

out vec4 v_others;  // a: share from deep inside
out vec3 v_own;

void add(uint point, float weight) {
    ivec2 texel = ivec2(2u * point % kColumns, 2u * point / kColumns);  // the other is beside it
    v_others += weight * texelFetch(point_light, texel, 0);
    v_own += weight * texelFetch(point_light, texel + ivec2(1, 0), 0).rgb;
}

void main() {
    gl_Position = clip_from_world * (world_from_local * vec4(position, 1.0));
    v_others = vec4(0.0);
    v_own = vec3(0.0);
    add(points.x & 0xffffu, weights.x);
    add(points.x >> 16, weights.y);
    add(points.y & 0xffffu, weights.z);
    add(points.y >> 16, weights.w);
    float sum = max(weights.x + weights.y + weights.z + weights.w, 1e-6);
    v_others /= sum;
    v_own /= sum;
}
