// A pixel of skin whose thickness is known: light comes through it as through a slab (transmission/transmission_pass.h).
#include "render/shaders/frame.glsl"
#include "render/shaders/gbuffer.glsl"
#include "skin/transmission/shares.glsl"

uniform sampler2D scene_depth;
uniform sampler2D gbuffer_normal;
uniform sampler2D gbuffer_surface;
uniform sampler2D skin_pixels;
uniform float first_map_technique;  // from this one on light spreads in maps
uniform float in_maps;              // 1 = only such skin, 0 = only other
uniform float least_use;            // of surfaces.glsl's thickness

/// How far behind the slab light is asked for, so that the slab does not shade itself: over its thickness, and metres.
const vec2 SKIN_BEHIND = vec2(0.15, 0.0005);

struct SkinSlab {
    SkinSurface skin;
    vec3 normal;    // of the side that is seen
    vec3 entry;     // a point of the other side
    vec3 share;     // of light that has entered there; 0 where the thickness does not count
    float roughness;
};

SkinSlab skin_slab() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    SurfacePoint mesh = decode_surface_point(texelFetch(gbuffer_surface, pixel, 0));
    SkinSlab slab;
    slab.skin = skin_surface(mesh.number);
    slab.normal = mesh.normal;
    float thickness = texelFetch(skin_pixels, pixel, 0).a;
    float maps = slab.skin.technique >= first_map_technique ? 1.0 : 0.0;
    bool counts = slab.skin.profile > 0.0 && maps == in_maps && slab.skin.thickness >= least_use && thickness >= 0.0;
    thickness = max(thickness, 0.0);
    float depth = texelFetch(scene_depth, pixel, 0).x;
    vec3 position = world_from_depth(gl_FragCoord.xy / frame.size_time.xy, max(depth, 1e-9));
    slab.entry = position - (thickness + SKIN_BEHIND.x * thickness + SKIN_BEHIND.y) * mesh.normal;
    float shown = counts ? slab.skin.transmission : 0.0;
    slab.share = shown * skin_share(skin_through_surface(mesh.number), thickness * thickness);
    slab.roughness = decode_lit_point(texelFetch(gbuffer_normal, pixel, 0)).roughness;
    return slab;
}
