// The shading model "skin". Diffuse light by a table over cosine and curvature (response.h); the oily layer as two lobes
// of GGX or as Kelemen & Szirmay-Kalos have it.
#include "physics/kelemen.glsl"
#include "render/shaders/gbuffer.glsl"
#include "render/shaders/lights.glsl"
#include "skin/response.glsl"
#include "skin/surfaces.glsl"

uniform sampler2D skin_gbuffer_surface;
uniform sampler2DArray skin_shadows;
uniform sampler2DArray skin_mirrors;  // oily_layer.h

/// Widest border of a shadow in the table, metres (ShadowResponse::kWidest_m).
const float SKIN_WIDEST_SHADOW = 0.02;

/// Metres over which the filter of the shadow maps draws a shadow's border at the point.
float skin_shadow_border(vec3 p, float nol) {
#ifdef ONE_LIGHT
    ShadowView view = light_data(0u).views[0];
    float texel = view.texel_page_fades.x * (view.page_from_world * vec4(p, 1.0)).w;
    return 5.0 * texel / max(nol, 0.2);
#else
    return 0.0;
#endif
}

vec3 skin_shadow(vec3 transmittance, float border, float layer) {
    vec2 size = vec2(textureSize(skin_shadows, 0).xy);
    vec3 share = clamp(transmittance, 0.0, 1.0);
    float v = (clamp(border / SKIN_WIDEST_SHADOW, 0.0, 1.0) * (size.y - 1.0) + 0.5) / size.y;
    float u = (dot(share, vec3(1.0 / 3.0)) * (size.x - 1.0) + 0.5) / size.x;
    return texture(skin_shadows, vec3(u, v, layer)).rgb;
}

vec2 skin_mirror_at(float cosine, float roughness, float layer) {
    vec2 at = standard_table_coordinate(cosine, roughness, float(textureSize(skin_mirrors, 0).x));
    return textureLod(skin_mirrors, vec3(at, layer), 0.0).xy;
}

LightTerms skin_shading_model(ShadingPoint s, LightSample l) {
    SurfacePoint mesh = decode_surface_point(texelFetch(skin_gbuffer_surface, ivec2(gl_FragCoord.xy), 0));
    SkinSurface skin = skin_surface(mesh.number);
    float nol = dot(s.normal, l.direction_to_light);
    float both = dot(s.normal, mesh.normal);
    vec3 flat_share = skin.flattened;
    // the cosine of the blend of both normals, brought to unit length
    vec3 cosines = mix(vec3(nol), vec3(dot(mesh.normal, l.direction_to_light)), flat_share) *
                   inversesqrt(max(1.0 - 2.0 * flat_share * (1.0 - flat_share) * (1.0 - both), 0.01));
    float nov = standard_nov(s.normal, s.view);
    float entering = skin_mirror_at(max(nol, 0.0), s.roughness, skin.mirror_layer).x;
    LightTerms terms;
    vec3 arriving = l.unshadowed * skin_shadow(l.transmittance, skin_shadow_border(s.position, nol), skin.response);
    terms.diffuse = arriving * skin_response(cosines, mesh.curvature, skin.response) * mix(1.0, entering, skin.mirror) *
                    skin_limb(skin, nov);

    vec3 sum = l.direction_to_light + s.view;
    float h2 = max(dot(sum, sum), 1e-12);
    vec3 h = sum * inversesqrt(h2);
    float lit = max(nol, 1e-4);
    vec2 alpha = vec2(ggx_alpha(s.roughness * skin.layer.x), ggx_alpha(s.roughness * skin.layer.y));
    float first = ggx_distribution(s.normal, h, alpha.x) * ggx_visibility(lit, nov, alpha.x);
    float second = ggx_distribution(s.normal, h, alpha.y) * ggx_visibility(lit, nov, alpha.y);
    float kelemen = kelemen_brdf(max(dot(s.normal, h), 1e-3), h2, s.roughness);
    float lobe = skin.layer.w > 0.5 ? kelemen : mix(first, second, skin.layer.z);
    lobe *= skin_mirror_at(nov, s.roughness, skin.mirror_layer).y;
    vec3 mirrored = l.irradiance * (max(nol, 0.0) * lobe);
    float w = schlick_weight(dot(s.view, h));
    terms.specular_a = mirrored * (1.0 - w);
    terms.specular_b = mirrored * w;
    return terms;
}
