// Adds one light to what arrives at a painted body.
#include "translucency/pixel.glsl"
#include "render/shaders/lights.glsl"
#include "seams/light_transmittance.glsl"
#include "translucency/paint/light.glsl"

layout(rgba16f) uniform image2D paint_light;
uniform uint light_index;

void main() {
    Pixel pixel = pixel_here();
    vec3 to_light;
    vec3 irradiance = light_irradiance(light_index, pixel.place, to_light) * max(dot(pixel.normal, to_light), 0.0);
    irradiance *= light_transmittance(light_index, pixel.place, pixel.normal);
    if (!pixel.seen) return;
    imageStore(paint_light, pixel.at, imageLoad(paint_light, pixel.at) + vec4(irradiance / kLightOfHalf, 0.0));
}
