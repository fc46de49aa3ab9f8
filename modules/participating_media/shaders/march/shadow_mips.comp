// Least and largest depth over parts of the shadow maps' pages: FIRST_LEVEL over 8x8 texels, then over 2x2 of what is finer.
layout(local_size_x = 8, local_size_y = 8) in;

layout(rg32f) writeonly uniform image2DArray coarser;
#ifdef FIRST_LEVEL
uniform sampler2DArray shadow_depths;
const int kSide = 8;
vec2 read(ivec3 at) { return vec2(texelFetch(shadow_depths, at, 0).r); }
#else
layout(rg32f) readonly uniform image2DArray finer;
const int kSide = 2;
vec2 read(ivec3 at) { return imageLoad(finer, at).rg; }
#endif

void main() {
    ivec3 at = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(at.xy, imageSize(coarser).xy))) return;
    vec2 range = vec2(1e30, -1e30);
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            vec2 one = read(ivec3(at.xy * kSide + ivec2(x, y), at.z));
            range = vec2(min(range.x, one.x), max(range.y, one.y));
        }
    }
    imageStore(coarser, at, vec4(range, 0.0, 0.0));
}
