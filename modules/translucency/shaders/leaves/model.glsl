// The shading model "thin": diffuse light goes back from the side that it arrives at, and comes through to the other.
// Shadows are looked up as for a surface that faces the light, so a leaf is not in its own.
#include "render/shaders/seam_types.glsl"

uniform sampler2D leaf_share;  // share.frag

LightReceiver thin_receiver(ShadingPoint s, vec3 to_light) {
    return LightReceiver(s.position, dot(s.normal, to_light) < 0.0 ? -s.normal : s.normal);
}

LightTerms thin_shading_model(ShadingPoint s, LightSample l) {
    LightTerms terms = standard_light(s.normal, s.view, l.direction_to_light, s.roughness, l.irradiance);
    vec3 through = texelFetch(leaf_share, ivec2(gl_FragCoord.xy), 0).rgb;
    float nol = dot(s.normal, l.direction_to_light);
    terms.diffuse = abs(nol) * l.irradiance * (nol > 0.0 ? 1.0 - through : through);
    return terms;
}
