// The pixels of one object, and what they show of light that leaves.
#include "translucency/lit_pixel.glsl"
#include "translucency/interior.glsl"

uniform sampler2D gbuffer_surface;
uniform float number;  // of the surface

Pixel pixel_here() {
    Pixel pixel = lit_pixel();
    ivec2 at = min(pixel.at, pixels_low + pixels_size - 1);
    pixel.seen = pixel.seen && surface_number(texelFetch(gbuffer_surface, at, 0)) == number;
    return pixel;
}

/// The irradiance that makes the base look as this exitance does. The compose pass multiplies by the base and by what the
/// mirror lets through, which is how light passes outward.
vec3 irradiance_as(vec3 exitance) { return exitance / (max(interior.base_entering.rgb, vec3(1e-4)) * mean_entering()); }
