// Light that enters skin nearby leaves here: along one direction of two (LINE) or from all around (DISC).
//
// Taps lie in the plane of the mesh's normal, in metres, along directions that hang on the world's up and on the
// surface: they neither follow the camera nor turn with it. What a tap hits may be farther away than the plane is there:
// another part of the body, or the plane's bend; it then counts less, as the kernel's widest Gaussian would have it.
#include "render/shaders/frame.glsl"
#include "render/shaders/gbuffer.glsl"
#include "skin/screen/colour.glsl"

uniform sampler2D gbuffer_surface;
uniform sampler2D from;        // irradiance, metres along the eye's axis; 0 = no skin
#ifndef DISC
uniform sampler2D skin_light;  // before any of it
uniform vec3 share;            // of spread light; the rest stays where it was
#endif
uniform vec4 taps[TAPS];       // rgb weight, metres
#ifdef DISC
uniform vec4 places[TAPS];  // xy metres
#endif
uniform float falloff;    // 1 / (2 variance), 1/m2
uniform float profile;    // this number's pixels
uniform float technique;  // and this technique's
layout(location = 0) out vec4 result;

vec2 place;            // of the pixel, pixels
vec2 plane_per_pixel;  // metres at 1 m from the eye
vec2 plane_corner;     // at pixel 0
vec3 here;             // of the pixel, metres before the eye
float pixel2;          // squared, m2
vec3 light;
vec3 total;

/// Adds light from `offset` pixels away, where the plane is `metres` away.
void add(vec2 offset, float metres, vec3 weight) {
    vec2 at = floor(clamp(place + offset, vec2(0.0), frame.size_time.xy - 1.0));
    vec4 tap = texelFetch(from, ivec2(at), 0);
    vec3 apart = tap.a * vec3(plane_corner + at * plane_per_pixel, -1.0) - here;
    float farther = max(dot(apart, apart) - 1.2 * metres * metres - pixel2, 0.0);
    // (1 - x / 4)^4 for e^-x
    float kept = max(1.0 - 0.25 * falloff * farther, 0.0);
    kept *= kept;
    weight *= tap.a > 0.0 ? kept * kept : 0.0;
    light += weight * tap.rgb;
    total += weight;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 middle = texelFetch(from, pixel, 0);
    SurfacePoint mesh = decode_surface_point(texelFetch(gbuffer_surface, pixel, 0));
    SkinSurface skin = skin_surface(mesh.number);
    bool mine = middle.a > 0.0 && skin.profile == profile && skin.technique == technique;
#ifdef LAST
    if (!mine) discard;
#endif
    place = gl_FragCoord.xy;
    plane_per_pixel = 2.0 * frame.tan_half_fov_exposure.xy / frame.size_time.xy;
    plane_corner = 0.5 * plane_per_pixel - frame.tan_half_fov_exposure.xy;
    vec2 plane = plane_corner + vec2(pixel) * plane_per_pixel;
    here = middle.a * vec3(plane, -1.0);
    pixel2 = square(middle.a * plane_per_pixel.y);
    vec3 normal = mat3(frame.view) * mesh.normal;
    vec3 up = mat3(frame.view) * (abs(mesh.normal.y) < 0.999 ? vec3(0.0, 1.0, 0.0) : vec3(0.0, 0.0, 1.0));
    vec3 along = cross(up, normal);
    along *= inversesqrt(max(dot(along, along), 1e-12));
    vec2 per_metre = 1.0 / (max(middle.a, 1e-6) * plane_per_pixel);
    vec2 along_pixels = (along.xy + plane * along.z) * per_metre;
    vec3 across = cross(normal, along);
    vec2 across_pixels = (across.xy + plane * across.z) * per_metre;

#ifdef DISC
    // the middle is for what comes after (average.frag), which takes nine pixels' turns together
    light = total = vec3(0.0);
    float turn = kTwoPi / 9.0 * float(pixel.x % 3 + 3 * (pixel.y % 3));
    vec2 turned = vec2(cos(turn), sin(turn));
    vec2 first_pixels = turned.x * along_pixels + turned.y * across_pixels;
    across_pixels = turned.x * across_pixels - turned.y * along_pixels;
    along_pixels = first_pixels;
#define TAP(i) add(places[i].x * along_pixels + places[i].y * across_pixels, taps[i].w, taps[i].rgb);
#else
    light = taps[0].rgb * middle.rgb;
    total = taps[0].rgb;
#ifdef LAST
    vec2 direction = across_pixels;
#else
    vec2 direction = along_pixels;
#endif
#define TAP(i) add(taps[i].w * direction, taps[i].w, taps[i].rgb); add(-taps[i].w * direction, taps[i].w, taps[i].rgb);
#endif
    for (int i = 1; i < TAPS; ++i) {  // which compilers write out
        TAP(i)
    }
    light = mix(middle.rgb, light / max(total, vec3(1e-9)), greaterThan(total, vec3(1e-6)));
#ifdef LAST
    light = mix(texelFetch(skin_light, pixel, 0).rgb, light, share);
    light /= skin_colour(pixel, skin);
#endif
    result = mine ? vec4(light, middle.a) : middle;
}
