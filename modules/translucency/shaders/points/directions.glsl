// A unit vector in one float: an octahedron's two coordinates as 12 bits each, exact in a float.
float packed_normal(vec3 n) {
    vec2 p = n.xy / max(abs(n.x) + abs(n.y) + abs(n.z), 1e-20);
    vec2 folded = (1.0 - abs(p.yx)) * vec2(p.x >= 0.0 ? 1.0 : -1.0, p.y >= 0.0 ? 1.0 : -1.0);
    vec2 steps = round(((n.z >= 0.0 ? p : folded) * 0.5 + 0.5) * 4095.0);
    return steps.x * 4096.0 + steps.y;
}
vec3 unpacked_normal(float number) {
    float x = floor(number / 4096.0);
    vec2 p = vec2(x, number - 4096.0 * x) / 4095.0 * 2.0 - 1.0;
    float z = 1.0 - abs(p.x) - abs(p.y), fold = max(-z, 0.0);
    return normalize(vec3(p.x + (p.x >= 0.0 ? -fold : fold), p.y + (p.y >= 0.0 ? -fold : fold), z));
}
