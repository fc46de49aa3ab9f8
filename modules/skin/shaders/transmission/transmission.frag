// Adds what of one light has come through thin parts to the light buffer, where skin is seen.
#include "render/shaders/frame.glsl"
#include "render/shaders/gbuffer.glsl"
#include "skin/transmission/transmitted.glsl"

uniform sampler2D scene_depth;
uniform sampler2D gbuffer_normal;
uniform sampler2D gbuffer_surface;
uniform uint light_index;
uniform float first_map_technique;  // from this one on light spreads in maps
uniform float in_maps;              // 1 = only such skin, 0 = only other

layout(location = 0) out vec4 light_diffuse;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    SurfacePoint mesh = decode_surface_point(texelFetch(gbuffer_surface, pixel, 0));
    SkinSurface skin = skin_surface(mesh.number);
    float maps = skin.technique >= first_map_technique ? 1.0 : 0.0;
    // those whose thickness counts for all lights are slab.frag's
    float number = maps == in_maps && skin.thickness < 2.0 ? mesh.number : 0.0;
    float depth = texelFetch(scene_depth, pixel, 0).x;
    vec3 position = world_from_depth(gl_FragCoord.xy / frame.size_time.xy, max(depth, 1e-9));
    float roughness = decode_lit_point(texelFetch(gbuffer_normal, pixel, 0)).roughness;
    light_diffuse = vec4(skin_transmitted(light_index, position, mesh.normal, number, roughness), 0.0);
}
