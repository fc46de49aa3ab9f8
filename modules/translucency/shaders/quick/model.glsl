// The shading model "interior": what the techniques wrap and thickness make of a light. Bodies of other techniques are
// lit plainly. QUICK_WRAP and QUICK_THICKNESS are defined where there are bodies of them.
#include "render/shaders/gbuffer.glsl"
#include "render/shaders/lights.glsl"
#include "seams/light_transmittance.glsl"

uniform sampler2D quick_bodies;    // a column a surface: quick/quick_table.h
uniform sampler2D quick_patterns;  // of light toward a cosine to the eye, two rows a body: quick/quick_body.h
uniform sampler2D quick_through;   // share of the light that goes through the body: thickness/share.comp
uniform sampler2D quick_gbuffer_surface;

const float kQuickWrap = 1.0, kQuickThickness = 2.0;  // QuickKind of quick/quick_table.h

vec4 quick_body(int row) {
    vec4 surface = texelFetch(quick_gbuffer_surface, ivec2(gl_FragCoord.xy), 0);
    return texelFetch(quick_bodies, ivec2(int(surface_number(surface)), row), 0);
}

/// A little above the surface the body's own curve is in no light's way, and its other parts still are.
LightReceiver interior_receiver(ShadingPoint s, vec3 to_light) {
    return LightReceiver(s.position + quick_body(0).y * s.normal, s.normal);
}

/// What other things leave of the light on its way to a body within the ball (middle, radius): not shaded by itself.
vec3 transmittance_to_body(uint light, vec3 p, vec3 to_light, vec4 ball) {
    vec3 offset = p - ball.xyz, unused;
    float along = dot(offset, to_light);
    float outside = -along + sqrt(max(along * along - dot(offset, offset) + ball.w * ball.w, 0.0));
    float distance_m = light_distance(light, p, unused);
    return light_transmittance(light, p + to_light * min(outside, 0.98 * distance_m), vec3(0.0));
}

/// Wrapped light over what a plane that faces the light gets (wrap/wrap_amount.h).
float quick_wrapped(float cosine, float a) {
    float above = max(cosine + a, 0.0) / (1.0 + a);
    return pow(above + 1e-9, 1.0 + a) * (2.0 + a) / (2.0 * (1.0 + a));
}

#ifdef QUICK_WRAP
/// A narrow wrap of the light here, the rest of the light around the body.
vec3 quick_wrap(vec3 here, vec3 around, float cosine) {
    vec3 wide = quick_body(2).rgb, even = quick_body(3).rgb;
    float half_cosine = 0.5 + 0.5 * cosine;
    return (1.0 - wide - even) * here + around * (wide * 0.75 * half_cosine * half_cosine + even * 0.25);
}
#endif

#ifdef QUICK_THICKNESS
/// Barre-Brisebois & Bouchard 2011; Real-Time Rendering (14.30): share of the light around the body that goes through it
/// toward the eye. A quarter: of parallel light a body receives so much a unit of its surface, if it is as round as a sphere.
float quick_lobe(ShadingPoint s, vec3 to_light) {
    vec4 lobe = quick_body(2);  // distortion, power, ambient, scale
    vec3 bent = normalize(to_light + lobe.x * s.normal + 1e-6 * s.view);
    float toward_eye = pow(max(dot(s.view, -bent), 1e-6), lobe.y);
    return 0.25 * lobe.w * mix((lobe.y + 1.0) * toward_eye, 1.0, lobe.z);
}
#endif

LightTerms interior_shading_model(ShadingPoint s, LightSample l) {
    LightTerms terms = standard_light(s.normal, s.view, l.direction_to_light, s.roughness, l.irradiance);
    vec4 body = quick_body(0), ball = quick_body(1);
    float cosine = dot(s.normal, l.direction_to_light);
    vec3 here = quick_wrapped(cosine, body.x) * l.irradiance;
    vec3 around = l.unshadowed * transmittance_to_body(l.light, s.position, l.direction_to_light, ball);
    ivec2 pattern = ivec2(int(standard_nov(s.normal, s.view) * float(textureSize(quick_patterns, 0).x - 1) + 0.5), int(body.w));
    vec3 near = texelFetch(quick_patterns, pattern, 0).rgb;
#ifdef QUICK_WRAP
    terms.diffuse = body.z == kQuickWrap ? near * quick_wrap(here, around, cosine) : terms.diffuse;
#endif
#ifdef QUICK_THICKNESS
    vec3 share = texelFetch(quick_through, ivec2(gl_FragCoord.xy), 0).rgb;
    vec3 deep = texelFetch(quick_patterns, pattern + ivec2(0, 1), 0).rgb;
    vec3 both = near * (1.0 - share) * here + deep * share * quick_lobe(s, l.direction_to_light) * around;
    terms.diffuse = body.z == kQuickThickness ? both : terms.diffuse;
#endif
    return terms;
}
