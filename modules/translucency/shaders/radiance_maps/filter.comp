// Halves the maps of what leaves: the mean of the texels that see something, where they lie on one surface.

layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2DArray places;
layout(rgba32f) readonly uniform image2DArray fine;
layout(rgba32f) writeonly uniform image2DArray coarse;
uniform int level;        // of the coarse one
uniform float same_unit;  // texels of one surface are nearer than this, in the body's unit

void main() {
    ivec3 texel = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(texel.xy, imageSize(coarse).xy))) return;
    vec4 place = texelFetch(places, texel, level), sum = vec4(0.0);
    float weights = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec3 at = ivec3(2 * texel.xy + ivec2(i & 1, i >> 1), texel.z);
        vec4 one = texelFetch(places, at, level - 1);
        float weight = one.w > 0.0 && distance(one.xyz, place.xyz) < same_unit ? 1.0 : 0.0;
        sum += weight * imageLoad(fine, at);
        weights += weight;
    }
    imageStore(coarse, texel, sum / max(weights, 1.0));
}
