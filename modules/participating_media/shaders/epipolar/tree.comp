// The shadow map along each slice's line, and the least and largest of its depths over 2, 4, 8 ... samples (Chen et al. 2011):
// column = slice, level k at row 2 n - (2 n >> k).
layout(local_size_x = 64) in;

uniform int slices;
uniform int shadow_samples;
uniform int level;
layout(rg32f) uniform image2D tree;
#ifdef FIRST_LEVEL
uniform sampler2DArray shadow_depths;
uniform float page;
layout(rgba32f) uniform readonly image2D slice_ends;
#endif

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);  // slice, node
    if (at.x >= slices) return;
#ifdef FIRST_LEVEL
    vec4 line = imageLoad(slice_ends, ivec2(at.x, 1));
    vec2 place = mix(line.xy, line.zw, (float(at.y) + 0.5) / float(shadow_samples));
    vec2 both = vec2(textureLod(shadow_depths, vec3(place, page), 0.0).r);
    imageStore(tree, at, vec4(both, 0.0, 0.0));
#else
    int whole = 2 * shadow_samples;
    int children = whole - (whole >> (level - 1)) + 2 * at.y;
    vec2 a = imageLoad(tree, ivec2(at.x, children)).rg;
    vec2 b = imageLoad(tree, ivec2(at.x, children + 1)).rg;
    imageStore(tree, ivec2(at.x, whole - (whole >> level) + at.y), vec4(min(a.x, b.x), max(a.y, b.y), 0.0, 0.0));
#endif
}
