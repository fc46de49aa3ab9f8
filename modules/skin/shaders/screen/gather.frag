// Light that enters skin nearby leaves here: one direction of two (LINE) or all around (DISC).
//
// Taps lie in the plane of the mesh's normal, in metres, along directions that hang on the world's up and on the
// surface: they neither follow the camera nor turn with it. What a tap hits may be farther away than the plane is there:
// another part of the body, or the plane's bend; the kernel is then smaller by its widest Gaussian.
#include "render/shaders/frame.glsl"
#include "render/shaders/gbuffer.glsl"
#include "skin/surfaces.glsl"

uniform sampler2D gbuffer_surface;
uniform sampler2D from;        // irradiance, metres along the eye's axis; 0 = no skin
uniform sampler2D skin_light;  // before any of it
uniform vec4 taps[TAPS];       // rgb weight, metres
#ifdef DISC
uniform vec4 places[TAPS];  // xy metres
#endif
uniform float falloff;    // 1 / (2 variance), 1/m2
uniform float profile;    // this number's pixels
uniform float technique;  // and this technique's
uniform float second;     // 1: the direction across the first
uniform vec3 share;       // of spread light; the rest stays where it was
layout(location = 0) out vec4 result;

// Adds light from `offset` pixels away, where the plane is `metres` away.
void add(vec2 offset, float metres, vec3 weight, vec3 here, vec2 plane_per_pixel, inout vec3 light, inout vec3 total) {
    vec2 pixels = round(offset);
    ivec2 at = clamp(ivec2(gl_FragCoord.xy) + ivec2(pixels), ivec2(0), ivec2(frame.size_time.xy) - 1);
    vec4 tap = texelFetch(from, at, 0);
    vec2 plane = (2.0 * (vec2(at) + 0.5) / frame.size_time.xy - 1.0) * frame.tan_half_fov_exposure.xy;
    vec3 apart = tap.a * vec3(plane, -1.0) - here;
    float pixel = 2.0 * here.z * plane_per_pixel.y;
    float farther = max(dot(apart, apart) - 1.2 * metres * metres - pixel * pixel, 0.0);
    weight *= tap.a > 0.0 ? exp(-falloff * farther) : 0.0;
    light += weight * tap.rgb;
    total += weight;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 middle = texelFetch(from, pixel, 0);
    SurfacePoint mesh = decode_surface_point(texelFetch(gbuffer_surface, pixel, 0));
    SkinSurface skin = skin_surface(mesh.number);
    result = middle;
    if (middle.a <= 0.0 || skin.profile != profile || skin.technique != technique) {
#ifdef LAST
        discard;
#endif
        return;
    }
    vec2 plane_per_pixel = frame.tan_half_fov_exposure.xy / frame.size_time.xy;  // half of it
    vec2 plane = (2.0 * (vec2(pixel) + 0.5) / frame.size_time.xy - 1.0) * frame.tan_half_fov_exposure.xy;
    vec3 here = middle.a * vec3(plane, -1.0);
    vec3 normal = mat3(frame.view) * mesh.normal;
    vec3 up = mat3(frame.view) * (abs(mesh.normal.y) < 0.999 ? vec3(0.0, 1.0, 0.0) : vec3(0.0, 0.0, 1.0));
    vec3 along = normalize(cross(up, normal));
    vec3 across = cross(normal, along);
    vec2 per_metre = 0.5 / (middle.a * plane_per_pixel);
    vec2 along_pixels = (along.xy + plane * along.z) * per_metre;
    vec2 across_pixels = (across.xy + plane * across.z) * per_metre;

    vec3 light = taps[0].rgb * middle.rgb;
    vec3 total = taps[0].rgb;
#ifdef DISC
    for (int i = 1; i < TAPS; ++i)
        add(places[i].x * along_pixels + places[i].y * across_pixels, taps[i].w, taps[i].rgb, here, plane_per_pixel,
            light, total);
#else
    vec2 direction = second > 0.5 ? across_pixels : along_pixels;
    for (int i = 1; i < TAPS; ++i) {
        add(taps[i].w * direction, taps[i].w, taps[i].rgb, here, plane_per_pixel, light, total);
        add(-taps[i].w * direction, taps[i].w, taps[i].rgb, here, plane_per_pixel, light, total);
    }
#endif
    light /= max(total, vec3(1e-6));
#ifdef LAST
    light = mix(texelFetch(skin_light, pixel, 0).rgb, light, share);
#endif
    result = vec4(light, middle.a);
}
