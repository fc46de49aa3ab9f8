// Single scattering of one light in one medium, once for each pixel: Gauss-Legendre quadrature, each node with its
// share of light as the moments of the visibility tell it.
#include "participating_media/light_source.glsl"
#include "participating_media/span.glsl"

uniform sampler2D spans;
uniform sampler2DArray moments;  // layer k: those of degree 4k..4k+3
uniform float unshadowed;        // 1: lit where no face says otherwise
uniform vec2 nodes[NODES];       // x and weight

in vec2 uv;
out vec4 in_scatter;  // rgb radiance, a unused

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 texel = texelFetch(spans, pixel, 0);
    Span span = Span(texel.x, texel.y, texel.z, texel.w);
    Ray ray = Ray(frame.eye_near.xyz, eye_ray(uv));
    Passing passing = passing_of(light_position(light_index) - ray.origin, ray.direction);
    float moment[TERMS];
    for (int k = 0; k < TERMS / 4; ++k) {
        vec4 four = texelFetch(moments, ivec3(pixel, k), 0);
        for (int j = 0; j < 4; ++j) moment[4 * k + j] = (float(4 * k + j) + 0.5) * four[j];
    }
    moment[0] += unshadowed;
#if defined(ONE_MEDIUM) && defined(EVEN_MEDIA)
    float entry = 0.0, leave = 1e9;
    clip_to_medium(medium, ray.origin, ray.direction, entry, leave);
#endif
    vec3 sum = vec3(0.0);
    for (int i = 0; i < (span.scale != 0.0 ? NODES : 0); ++i) {
        float x = nodes[i].x;
        float share = moment[0], before = 1.0, here = x;
        for (int j = 1; j < TERMS; ++j) {
            float degree = float(j);
            float after = ((2.0 * degree + 1.0) * x * here - degree * before) / (degree + 1.0);
            share += moment[j] * here;
            before = here;
            here = after;
        }
        float metres;
        float t = from_parameter(span, passing, x, metres);
#if defined(ONE_MEDIUM) && defined(EVEN_MEDIA)
        vec3 to_eye = exp(-media[medium].sigma_t.rgb * (t - entry));
#else
        vec3 to_eye = media_transmittance(ray.origin, ray.direction, 0.0, t);
#endif
        sum += source(ray, t) * to_eye * (nodes[i].y * metres * share);
    }
    in_scatter = vec4(media[medium].sigma_s_phase.rgb * sum, 0.0);
}
