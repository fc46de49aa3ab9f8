// What all that is marched shares. A ray's light comes with its guide: what would come without shadows, phase function and
// extinction. The guide is cheap and known at each pixel of the frame, and what it has in it, the inverse-square law and where
// rays end, no filter need blur. GUIDE_ONLY: nothing but that is asked for.
#include "participating_media/march/ray.glsl"
#include "physics/units.glsl"

uniform float least_transmittance;  // rays end where no more of the light comes to the eye

#ifndef GUIDE_ONLY
uniform sampler2D blue_noise;
uniform int steps;
uniform float fixed_offset;  // of a step; negative = by blue noise
uniform float frame_offset;  // added to the noise

float step_offset(ivec2 at) {
    return fixed_offset >= 0.0 ? fixed_offset : fract(texelFetch(blue_noise, at & 63, 0).r + frame_offset);
}
#endif


float least(vec3 rgb) { return min(rgb.r, min(rgb.g, rgb.b)); }

float largest(vec3 rgb) { return max(rgb.r, max(rgb.g, rgb.b)); }
