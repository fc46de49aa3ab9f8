// Irradiance that enters skin, and metres along the eye's axis; nothing where there is no skin. Colour to a power
// counts where light enters.
#include "render/shaders/frame.glsl"
#include "render/shaders/gbuffer.glsl"
#include "skin/screen/colour.glsl"

uniform sampler2D scene_depth;
uniform sampler2D gbuffer_surface;
uniform sampler2D light_diffuse;
layout(location = 0) out vec4 skin_light;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    SkinSurface skin = skin_surface(surface_number(texelFetch(gbuffer_surface, pixel, 0)));
    float depth = texelFetch(scene_depth, pixel, 0).x;
    vec3 light = texelFetch(light_diffuse, pixel, 0).rgb;
    light *= skin_colour(pixel, skin);
    skin_light = skin.profile > 0.0 ? vec4(light, view_depth(max(depth, 1e-9))) : vec4(0.0);
}
