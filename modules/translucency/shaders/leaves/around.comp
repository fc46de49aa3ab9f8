// Light from all around: what comes through from the far side, and what is left of the near side's.
#include "translucency/lit_pixel.glsl"
#include "seams/indirect_light.glsl"

uniform sampler2D leaf_share;  // share.frag; alpha 0 where there is none

void main() {
    Pixel pixel = lit_pixel();
    vec3 far = -pixel.normal;
    vec3 irradiance = indirect_light(pixel.place, far, far, 1.0).irradiance * pixel.occlusion;
    vec4 share = texelFetch(leaf_share, pixel.at, 0);
    if (!pixel.seen || share.a == 0.0) return;
    vec3 near = imageLoad(light_diffuse, pixel.at).rgb;
    imageStore(light_diffuse, pixel.at, vec4(mix(near, irradiance, share.rgb), 0.0));
}
