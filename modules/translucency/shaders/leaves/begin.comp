// Takes away what goes through of the light on the near side, and begins with light from all around the far side.
#include "translucency/leaves/leaf.glsl"
#include "seams/indirect_light.glsl"

void main() {
    Pixel pixel = lit_pixel();
    vec3 far = -pixel.normal;
    add_far_light(pixel, indirect_light(pixel.place, far, far, 1.0).irradiance * pixel.occlusion, 1.0);
}
