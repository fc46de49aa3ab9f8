// Takes away what the object's pixels had and begins with light from all around: as much of it leaves a body as enters,
// but for what is absorbed, and little less evenly than it arrives.
#include "translucency/pixel.glsl"
#include "seams/indirect_light.glsl"

uniform float elsewhere;  // 1: a technique whose light wanders to elsewhere goes on; 0: none of it does

void main() {
    Pixel pixel = pixel_here();
    vec3 irradiance = indirect_light(pixel.place, pixel.normal, pixel.normal, 1.0).irradiance * pixel.occlusion;
    vec3 exitance = irradiance * mean_entering() * mean_leaving() * near_pattern(pixel.cosine);
    exitance *= mix(vec3(1.0), leaves_where_it_enters(pixel.place), elsewhere);
    if (pixel.seen) imageStore(light_diffuse, pixel.at, vec4(irradiance_as(exitance), 0.0));
}
