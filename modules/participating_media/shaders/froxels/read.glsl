// What the froxels found between the eye and a point.
#include "participating_media/froxels/grid.glsl"

// FROXEL_IMAGES: read as images, which compute shaders do faster.
#ifdef FROXEL_IMAGES
layout(rgba32f) readonly uniform image3D froxel_radiance;  // integrate.comp
layout(rgba32f) readonly uniform image2D froxel_columns;   // columns.comp
vec4 froxel_texel(ivec3 at) { return imageLoad(froxel_radiance, froxel_place(at)); }
float froxel_farthest(ivec2 column) { return imageLoad(froxel_columns, column).x; }
#else
uniform sampler3D froxel_radiance;
uniform sampler2D froxel_columns;
vec4 froxel_texel(ivec3 at) { return texelFetch(froxel_radiance, froxel_place(at), 0); }
float froxel_farthest(ivec2 column) { return texelFetch(froxel_columns, column, 0).x; }
#endif

// Radiance from the eye to `depth` metres along its axis. Along the ray within a slice the light follows the
// transmittance; across, columns count by their nearness and less when their view ends before the point.
vec3 froxel_in_scatter(vec2 uv, float depth) {
    float slices = float(froxel_size.z);
    float slice = clamp(floor(froxel_share(depth) * slices), 0.0, slices - 1.0);
    float z0 = froxel_depth(slice / slices);
    float within = clamp((depth - z0) / (froxel_end(z0) - z0), 0.0, 1.0);
    vec2 place = uv * vec2(froxel_size.xy) - 0.5;
    ivec2 corner = ivec2(floor(place));
    vec2 f = place - vec2(corner);
    vec4 low = vec4(0.0), high = vec4(0.0);
    float total = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 offset = ivec2(i & 1, i >> 1);
        ivec2 column = clamp(corner + offset, ivec2(0), froxel_size.xy - 1);
        float missing = 25.0 * max(depth - froxel_farthest(column), 0.0) / depth;
        vec2 w = mix(1.0 - f, f, vec2(offset));
        float weight = (w.x * w.y + 1e-4) / (1.0 + missing * missing);
        low += weight * froxel_texel(ivec3(column, int(slice)));
        high += weight * froxel_texel(ivec3(column, int(slice) + 1));
        total += weight;
    }
    float passed = clamp(high.a / max(low.a, 1e-20), 1e-6, 1.0);
    float share = passed > 0.999 ? within : (1.0 - pow(passed, within)) / (1.0 - passed);
    return depth > froxel_depths.x ? mix(low.rgb, high.rgb, share) / total : vec3(0.0);
}
