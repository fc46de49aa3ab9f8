// Where a ray from a light and a place in the world lie in the light's map (shadows/shadow_fit.h).
const int MAP_PARALLEL = 0;
const int MAP_PYRAMID = 1;
const int MAP_OCTAHEDRON = 2;

// The octahedron unfolded onto [-1, 1]^2 (Cigolle et al. 2014).
vec2 octahedron_unfold(vec3 d) {
    vec2 p = d.xy / (abs(d.x) + abs(d.y) + abs(d.z));
    vec2 folded = (1.0 - abs(p.yx)) * vec2(p.x >= 0.0 ? 1.0 : -1.0, p.y >= 0.0 ? 1.0 : -1.0);
    return d.z >= 0.0 ? p : folded;
}

// The way back; a texel beyond the square's border is that which lies there on the octahedron, across the fold.
vec3 octahedron_fold(vec2 p) {
    vec2 beyond = abs(p);
    p = beyond.x > 1.0 ? vec2(sign(p.x) * 2.0 - p.x, -p.y) : p;
    p = beyond.y > 1.0 ? vec2(-p.x, sign(p.y) * 2.0 - p.y) : p;
    float z = 1.0 - abs(p.x) - abs(p.y);
    float fold = max(-z, 0.0);
    return normalize(vec3(p.x + (p.x >= 0.0 ? -fold : fold), p.y + (p.y >= 0.0 ? -fold : fold), z));
}
