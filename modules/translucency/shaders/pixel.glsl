// The pixels of one object, and what they show of light that leaves.
#include "translucency/lit_pixel.glsl"
#include "translucency/interior.glsl"

uniform sampler2D gbuffer_surface;
uniform float number;  // of the surface

bool number_at(ivec2 at) { return surface_number(texelFetch(gbuffer_surface, at, 0)) == number; }

Pixel pixel_here() {
    Pixel pixel = lit_pixel();
    pixel.seen = pixel.seen && number_at(min(pixel.at, pixels_low + pixels_size - 1));
    return pixel;
}

/// Invocations that look at a column of pixels each do no more than is seen, which a processor that renders skips in no
/// other way (dispatch_columns of seen_surface.h):
///
///     ivec2 at = first_seen();
///     do {
///         Pixel pixel = pixel_at(at);
///         ...
///         at = next_seen(at);
///     } while (within_column(at));
const int kColumn = 8;

bool within_column(ivec2 at) {
    int begin = int(gl_GlobalInvocationID.y) * kColumn;
    return at.y < pixels_low.y + min(begin + kColumn, pixels_size.y);
}
ivec2 next_seen(ivec2 at) {
    do ++at.y;
    while (within_column(at) && !number_at(at));
    return at;
}
ivec2 first_seen() {
    ivec2 at = pixels_low + ivec2(gl_GlobalInvocationID.xy) * ivec2(1, kColumn);
    if (at.x >= pixels_low.x + pixels_size.x) at.y += kColumn;  // beyond the rectangle: none
    return next_seen(ivec2(at.x, at.y - 1));
}
/// The first of an empty column is not seen.
Pixel pixel_at(ivec2 at) {
    Pixel pixel = lit_pixel_at(at);
    pixel.seen = within_column(at);
    return pixel;
}

/// The irradiance that makes the base look as this exitance does. The compose pass multiplies by the base and by what the
/// mirror lets through, which is how light passes outward.
vec3 irradiance_as(vec3 exitance) { return exitance / (max(interior.base_entering.rgb, vec3(1e-4)) * mean_entering()); }
