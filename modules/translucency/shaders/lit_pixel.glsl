// Pixels of surfaces whose light a compute shader turns into other light.
#include "render/shaders/frame.glsl"
#include "render/shaders/gbuffer.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f) uniform image2D light_diffuse;
uniform sampler2D scene_depth;
uniform sampler2D gbuffer_normal;
uniform ivec2 pixels_low;
uniform ivec2 pixels_size;

struct Pixel {
    ivec2 at;
    bool seen;
    vec3 place;
    vec3 normal;
    float occlusion;
    float cosine;  // of the normal to the eye
};

/// A pixel, or the nearest in the rectangle.
Pixel lit_pixel_at(ivec2 pixel_at) {
    Pixel pixel;
    pixel.at = pixel_at;
    ivec2 at = min(pixel_at, pixels_low + pixels_size - 1);
    pixel.seen = at == pixel.at;
    LitPoint point = decode_lit_point(texelFetch(gbuffer_normal, at, 0));
    vec2 uv = (vec2(at) + 0.5) / frame.size_time.xy;
    pixel.place = world_from_depth(uv, max(texelFetch(scene_depth, at, 0).x, 1e-9));
    pixel.normal = point.normal;
    pixel.occlusion = point.occlusion;
    pixel.cosine = standard_nov(point.normal, -eye_ray(uv));
    return pixel;
}

/// The invocation's pixel: seen when it is inside of the rectangle.
Pixel lit_pixel() { return lit_pixel_at(pixels_low + ivec2(gl_GlobalInvocationID.xy)); }
