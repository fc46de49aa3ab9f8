// Adds one light, wrapped around the body (wrap/wrap_amount.h).
#include "translucency/pixel.glsl"
#include "translucency/around.glsl"

uniform float keeps;  // 0: takes the place of what the pixel had

void main() {
    ivec2 at = first_seen();
    do {
        Pixel pixel = pixel_at(at);
        vec3 to_light;
        vec3 irradiance = light_irradiance(light_index, pixel.place, to_light);
        vec3 around = irradiance * transmittance_to_body(pixel.place, to_light);
        vec3 light = wrapped_light(irradiance, around, pixel.place, pixel.normal, dot(pixel.normal, to_light));
        vec3 exitance = light * mean_entering() * mean_leaving() * near_pattern(pixel.cosine);
        if (pixel.seen) {
            vec4 had = keeps * imageLoad(light_diffuse, at);
            imageStore(light_diffuse, at, had + vec4(irradiance_as(exitance), 0.0));
        }
        at = next_seen(at);
    } while (within_column(at));
}
