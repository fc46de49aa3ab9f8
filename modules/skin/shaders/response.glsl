// What the light pass makes of a light: the tables of response.h.
#include "render/shaders/gbuffer.glsl"

uniform sampler2DArray skin_responses;

/// Diffuse light of a channel each at three cosines.
vec3 skin_response(vec3 cosines, float curvature, float layer) {
    vec2 size = vec2(textureSize(skin_responses, 0).xy);
    vec3 u = (clamp(cosines * 0.5 + 0.5, 0.0, 1.0) * (size.x - 1.0) + 0.5) / size.x;
    float v = (curvature / (curvature + CURVATURE_MIDDLE) * (size.y - 1.0) + 0.5) / size.y;
    return vec3(textureLod(skin_responses, vec3(u.x, v, layer), 0.0).r,
                textureLod(skin_responses, vec3(u.y, v, layer), 0.0).g,
                textureLod(skin_responses, vec3(u.z, v, layer), 0.0).b);
}
