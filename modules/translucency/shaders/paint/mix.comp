// Light of a painted surface's pixels: of paint what has arrived there, of what is open what has come through the body.
#include "translucency/pixel.glsl"
#include "translucency/paint/light.glsl"

uniform sampler2D paint_share;
uniform sampler2D paint_light;
uniform float wanders;  // 1: light has come from where it entered; 0: it has not been thrown back inside
uniform float stays;    // 1: light is taken to leave where it entered

void main() {
    Pixel pixel = pixel_here();
    vec3 share = texelFetch(paint_share, pixel.at, 0).rgb, light = kLightOfHalf * texelFetch(paint_light, pixel.at, 0).rgb;
    vec3 out_of_paint = mix(vec3(1.0), paint_ends_at(pixel.place).rgb, wanders);
    out_of_paint = mix(out_of_paint, leaves_past_paint(pixel.place), stays);
    vec3 through = out_of_paint * imageLoad(light_diffuse, pixel.at).rgb;
    if (pixel.seen) imageStore(light_diffuse, pixel.at, vec4(mix(through, light, share), 0.0));
}
