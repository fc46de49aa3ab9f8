// The pixels of one object, and what they show of light that leaves.
#include "render/shaders/frame.glsl"
#include "render/shaders/gbuffer.glsl"
#include "translucency/interior.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f) uniform image2D light_diffuse;
uniform sampler2D scene_depth;
uniform sampler2D gbuffer_normal;
uniform sampler2D gbuffer_surface;
uniform ivec2 pixels_low;
uniform ivec2 pixels_size;
uniform float number;  // of the surface

struct Pixel {
    ivec2 at;
    bool seen;
    vec3 place;
    vec3 normal;
    float occlusion;
    float cosine;  // of the normal to the eye
};

Pixel pixel_here() {
    Pixel pixel;
    pixel.at = pixels_low + ivec2(gl_GlobalInvocationID.xy);
    ivec2 at = min(pixel.at, pixels_low + pixels_size - 1);
    pixel.seen = at == pixel.at && surface_number(texelFetch(gbuffer_surface, at, 0)) == number;
    LitPoint point = decode_lit_point(texelFetch(gbuffer_normal, at, 0));
    vec2 uv = (vec2(at) + 0.5) / frame.size_time.xy;
    pixel.place = world_from_depth(uv, max(texelFetch(scene_depth, at, 0).x, 1e-9));
    pixel.normal = point.normal;
    pixel.occlusion = point.occlusion;
    pixel.cosine = standard_nov(point.normal, -eye_ray(uv));
    return pixel;
}

/// The irradiance that makes the base look as this exitance does. The compose pass multiplies by the base and by what the
/// mirror lets through, which is how light passes outward.
vec3 irradiance_as(vec3 exitance) { return exitance / (max(interior.base_entering.rgb, vec3(1e-4)) * mean_entering()); }
