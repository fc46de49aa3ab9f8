// Where the eye ray leaves the light (back faces: added) and comes into it (front faces: taken away): integrals of the
// Legendre polynomials up to there. All faces together: the moments of the light's visibility along the ray. What lies
// before the span or behind it counts as at its ends: no face need be cut at a surface.
#include "participating_media/span.glsl"

uniform sampler2D spans;

in vec3 from_eye;
layout(location = 0) out vec4 moments[TERMS / 4];

void main() {
    vec4 texel = texelFetch(spans, ivec2(gl_FragCoord.xy), 0);
    Span span = Span(texel.x, texel.y, texel.z, texel.w);
    float t = length(from_eye);
    Passing passing = passing_of(light_position(0u) - frame.eye_near.xyz, from_eye / t);
    float x = to_parameter(span, passing, t);
    float out_of_light = gl_FrontFacing ? -1.0 : 1.0;
    // integral of P_j = (P_(j+1) - P_(j-1)) / (2j + 1)
    float integral[TERMS];
    integral[0] = out_of_light * (x + 1.0);
    float before = 1.0, here = x;
    for (int j = 1; j < TERMS; ++j) {
        float degree = float(j);
        float after = ((2.0 * degree + 1.0) * x * here - degree * before) / (degree + 1.0);
        integral[j] = out_of_light * (after - before) / (2.0 * degree + 1.0);
        before = here;
        here = after;
    }
    // outputs are not indexed by loops: not every driver lets them
    moments[0] = vec4(integral[0], integral[1], integral[2], integral[3]);
#if TERMS > 4
    moments[1] = vec4(integral[4], integral[5], integral[6], integral[7]);
#endif
#if TERMS > 8
    moments[2] = vec4(integral[8], integral[9], integral[10], integral[11]);
#endif
#if TERMS > 12
    moments[3] = vec4(integral[12], integral[13], integral[14], integral[15]);
#endif
}
