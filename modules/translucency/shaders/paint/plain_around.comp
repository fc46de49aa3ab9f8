// Begins the light that arrives at a painted body, of which the light pass has added what leaves, with that from all around.
#include "translucency/pixel.glsl"
#include "seams/indirect_light.glsl"
#include "translucency/paint/light.glsl"

layout(rgba16f) writeonly uniform image2D paint_light;

void main() {
    Pixel pixel = pixel_here();
    vec3 irradiance = indirect_light(pixel.place, pixel.normal, pixel.normal, 1.0).irradiance * pixel.occlusion;
    if (pixel.seen) imageStore(paint_light, pixel.at, vec4(irradiance / kLightOfHalf, 0.0));
}
