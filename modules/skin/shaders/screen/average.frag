// The technique disc's second half: what the rings of nine pixels have found, and each pixel's own middle.
#include "render/shaders/frame.glsl"
#include "render/shaders/gbuffer.glsl"
#include "skin/screen/colour.glsl"

uniform sampler2D gbuffer_surface;
uniform sampler2D from;        // light from the rings, metres along the eye's axis
uniform sampler2D skin_light;  // irradiance before it spread
uniform vec3 middle;           // share of light that stays in the pixel
uniform float same;            // metres within which pixels are of one surface
uniform float profile;
uniform float technique;
layout(location = 0) out vec4 result;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 here = texelFetch(skin_light, pixel, 0);
    SkinSurface skin = skin_surface(surface_number(texelFetch(gbuffer_surface, pixel, 0)));
    if (here.a <= 0.0 || skin.profile != profile || skin.technique != technique) discard;
    ivec2 last = ivec2(frame.size_time.xy) - 1;
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 9; ++i) {
        vec4 ring = texelFetch(from, clamp(pixel + ivec2(i % 3 - 1, i / 3 - 1), ivec2(0), last), 0);
        sum += abs(ring.a - here.a) < same ? vec4(ring.rgb, 1.0) : vec4(0.0);
    }
    result = vec4(mix(sum.rgb / max(sum.a, 1.0), here.rgb, middle) / skin_colour(pixel, skin), 0.0);
}
