// Adds one light on the far side. Its shadows are looked up as for a surface that faces it, so a leaf is not in its own.
#include "translucency/leaves/leaf.glsl"
#include "render/shaders/lights.glsl"
#include "seams/light_transmittance.glsl"

uniform uint light_index;
uniform float begins;

void main() {
    Pixel pixel = lit_pixel();
    vec3 far = -pixel.normal, to_light;
    vec3 irradiance = light_irradiance(light_index, pixel.place, to_light) * max(dot(far, to_light), 0.0);
    add_far_light(pixel, irradiance * light_transmittance(light_index, pixel.place, far), begins);
}
