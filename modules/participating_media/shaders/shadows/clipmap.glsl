// Extinction of uneven media in nested boxes of voxels around the camera (shadows/extinction_clipmap.h).
uniform sampler3D media_clipmap;            // levels stacked, the finest first
uniform ivec3 clipmap_size;                 // levels, voxels on a side, steps of a lookup
uniform vec3 clipmap_low[6];                // of a level's box in the world
uniform vec3 clipmap_inverse_extent[6];

// The finest level that holds the place a voxel from its border, and whose voxels are not finer than the steps need.
int clipmap_level(vec3 p, float step_m) {
    int level = clipmap_size.x - 1;
    float voxels = float(clipmap_size.y);
    for (int l = clipmap_size.x - 2; l >= 0; --l) {
        vec3 at = (p - clipmap_low[l]) * clipmap_inverse_extent[l];
        float finest = min(clipmap_inverse_extent[l].x, min(clipmap_inverse_extent[l].y, clipmap_inverse_extent[l].z));
        bool inside = all(greaterThan(at, vec3(1.0 / voxels))) && all(lessThan(at, vec3(1.0 - 1.0 / voxels)));
        level = inside && step_m * finest * voxels < 2.0 ? l : level;
    }
    return level;
}

vec3 clipmap_extinction(int level, vec3 p) {
    float voxels = float(clipmap_size.y);
    vec3 at = (p - clipmap_low[level]) * clipmap_inverse_extent[level];
    at.z = (float(level) * voxels + clamp(at.z * voxels, 0.5, voxels - 0.5)) / (voxels * float(clipmap_size.x));
    return textureLod(media_clipmap, at, 0.0).rgb;
}

// Optical depth toward the light: steps grow with their distance from p, and so do the voxels that are looked at.
vec3 clipmap_depth(vec3 p, vec3 to_light, float metres) {
    int whole = clipmap_size.x - 1;
    vec3 inverse = 1.0 / mix(to_light, vec3(1e-20), lessThan(abs(to_light), vec3(1e-20)));
    vec3 a = (clipmap_low[whole] - p) * inverse;
    vec3 b = a + inverse / clipmap_inverse_extent[whole];
    vec3 near = min(a, b), far = max(a, b);
    float t0 = max(0.0, max(near.x, max(near.y, near.z)));
    float t1 = min(metres, min(far.x, min(far.y, far.z)));
    float span = t1 - t0;
    float curve = span / max(t1, 1e-6);  // 1 from inside the media, 0 from far away
    int steps = span > 0.0 ? clipmap_size.z : 0;
    vec3 depth = vec3(0.0);
    float begin = 0.0;
    for (int i = 1; i <= steps; ++i) {
        float u = float(i) / float(steps);
        float end = u * mix(1.0, u, curve);
        float step_m = (end - begin) * span;
        vec3 at = p + (t0 + mix(begin, end, media_sample_offset) * span) * to_light;
        depth += clipmap_extinction(clipmap_level(at, step_m), at) * step_m;
        begin = end;
    }
    return depth;
}
