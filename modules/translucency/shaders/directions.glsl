// A unit vector in one float: its octahedral coordinates as 12 bits each, exact in a float.
#include "render/shaders/gbuffer.glsl"

float packed_normal(vec3 n) {
    vec2 steps = round(encode_octahedral(n / max(length(n), 1e-20)) * 4095.0);
    return steps.x * 4096.0 + steps.y;
}
vec3 unpacked_normal(float number) {
    float x = floor(number / 4096.0);
    return decode_octahedral(vec2(x, number - 4096.0 * x) / 4095.0);
}
