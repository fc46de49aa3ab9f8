// What of a pixel's colour counts where light enters: 1 but with COLOURED, from the G-buffer with BASE, which the light
// pre-pass has not, and else from skin drawn once more (pixels/surface_pixels_pass.h).
#include "skin/surfaces.glsl"
#include "skin/texture_space/slot.glsl"

#ifdef BASE
uniform sampler2D gbuffer_base;
#else
uniform sampler2D skin_pixels;
#endif

vec3 skin_colour(ivec2 pixel, SkinSurface skin) {
#ifndef COLOURED
    return vec3(1.0);
#elif defined(BASE)
    return pow(max(texelFetch(gbuffer_base, pixel, 0).rgb, vec3(kLeastColour)), vec3(skin.pre_scatter));
#else
    return texelFetch(skin_pixels, pixel, 0).rgb;
#endif
}
