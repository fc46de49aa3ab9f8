// What the light pass makes of a light: the tables of response.h.
#include "render/shaders/gbuffer.glsl"

uniform sampler2DArray skin_responses;

/// Where a row of the table is, and the width of it.
vec2 skin_response_row(float curvature) {
    vec2 size = vec2(textureSize(skin_responses, 0).xy);
    return vec2((curvature / (curvature + CURVATURE_MIDDLE) * (size.y - 1.0) + 0.5) / size.y, size.x);
}

/// Diffuse light at a cosine.
vec3 skin_response(float cosine, float curvature, float layer) {
    vec2 row = skin_response_row(curvature);
    float u = (clamp(cosine * 0.5 + 0.5, 0.0, 1.0) * (row.y - 1.0) + 0.5) / row.y;
    return textureLod(skin_responses, vec3(u, row.x, layer), 0.0).rgb;
}

/// Diffuse light of a channel each at three cosines.
vec3 skin_response(vec3 cosines, float curvature, float layer) {
    vec2 row = skin_response_row(curvature);
    vec3 u = (clamp(cosines * 0.5 + 0.5, 0.0, 1.0) * (row.y - 1.0) + 0.5) / row.y;
    return vec3(textureLod(skin_responses, vec3(u.x, row.x, layer), 0.0).r,
                textureLod(skin_responses, vec3(u.y, row.x, layer), 0.0).g,
                textureLod(skin_responses, vec3(u.z, row.x, layer), 0.0).b);
}
