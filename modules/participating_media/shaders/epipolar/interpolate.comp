// Every sample of a slice, from those that were looked at.
layout(local_size_x = 64) in;

uniform int slices;
layout(rg32f) uniform readonly image2D sources;
layout(rgba32f) uniform readonly image2D looks;
layout(r32f) uniform readonly image2D distances;
layout(rgba32f) uniform writeonly image2D lines;  // rgb radiance, a metres to the surface, negative where there is no slice

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (at.x >= slices) return;
    ivec2 both = ivec2(imageLoad(sources, at).rg);
    float share = both.x == both.y ? 0.0 : float(at.y - both.x) / float(both.y - both.x);
    vec3 light = mix(imageLoad(looks, ivec2(at.x, both.x)).rgb, imageLoad(looks, ivec2(at.x, both.y)).rgb, share);
    imageStore(lines, at, vec4(light, imageLoad(distances, at).r));
}
