// Chooses the pixels at which a solid's blurred light is found.
#include "render/shaders/gbuffer.glsl"

uniform sampler2D scene_depth;
uniform sampler2D gbuffer_surface;
uniform float number;
layout(location = 0) out vec4 found;  // places.glsl

void main() {
    found = vec4(0.0);
    ivec2 last = textureSize(gbuffer_surface, 0) - 1;
    for (int i = 3; i >= 0; --i) {
        ivec2 pixel = min(2 * ivec2(gl_FragCoord.xy) + ivec2(i & 1, i >> 1), last);
        if (surface_number(texelFetch(gbuffer_surface, pixel, 0)) == number) found = vec4(texelFetch(scene_depth, pixel, 0).x, float(i), 0.0, 0.0);
    }
}
