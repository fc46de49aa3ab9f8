// A pixel of a thin surface, and the light that it gets from the far side.
#include "translucency/lit_pixel.glsl"

uniform sampler2D leaf_share;  // share.frag; alpha 0 where there is none

/// Adds light of the far side; what goes through of the near side is taken away first where this `begins` (1, or 0).
void add_far_light(Pixel pixel, vec3 irradiance, float begins) {
    if (!pixel.seen) return;
    vec4 share = texelFetch(leaf_share, pixel.at, 0);
    if (share.a == 0.0) return;
    vec3 had = imageLoad(light_diffuse, pixel.at).rgb;
    vec3 kept = had - begins * share.rgb * had;
    imageStore(light_diffuse, pixel.at, vec4(kept + share.rgb * irradiance, 0.0));
}
