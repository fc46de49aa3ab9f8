// What share of a painted surface's diffuse colour is the paint's, and the light that has arrived there.
#include "render/shaders/material.glsl"
#include "translucency/paint/light.glsl"

uniform sampler2D light_diffuse;
layout(location = 0) out vec4 paint_share;
layout(location = 1) out vec4 paint_light;

void main() {
    paint_share = vec4(material_at().painted, 1.0);
    paint_light = texelFetch(light_diffuse, ivec2(gl_FragCoord.xy), 0) / kLightOfHalf;
}
