// Octahedral maps of the specular light of probes (render/light_probes.cpp: keep the sizes the same).

// The octahedron's edge lies on the centres of the outermost texels of the coarsest mip, so that filtering never reads
// across it; finer mips continue it beyond.
const float kProbeBorder = 0.5 / 8.0;
const float kProbeLastMip = 4.0;

vec2 probe_uv_from_direction(vec3 d) {
    vec2 p = d.xz / (abs(d.x) + abs(d.y) + abs(d.z));
    vec2 folded = (1.0 - abs(p.yx)) * vec2(p.x >= 0.0 ? 1.0 : -1.0, p.y >= 0.0 ? 1.0 : -1.0);
    vec2 unit = (d.y >= 0.0 ? p : folded) * 0.5 + 0.5;
    return kProbeBorder + unit * (1.0 - 2.0 * kProbeBorder);
}

// Of any point of the map, its border too: what lies beyond an edge is the other half of that edge.
vec3 probe_direction_from_uv(vec2 uv) {
    vec2 p = (uv - kProbeBorder) / (1.0 - 2.0 * kProbeBorder) * 2.0 - 1.0;
    if (abs(p.x) > 1.0) p = vec2(sign(p.x) * (2.0 - abs(p.x)), -p.y);
    if (abs(p.y) > 1.0) p = vec2(-p.x, sign(p.y) * (2.0 - abs(p.y)));
    float y = 1.0 - abs(p.x) - abs(p.y);
    float fold = max(-y, 0.0);
    return normalize(vec3(p.x + (p.x >= 0.0 ? -fold : fold), y, p.y + (p.y >= 0.0 ? -fold : fold)));
}
