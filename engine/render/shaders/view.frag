// Shows a target of the frame, the layers of an array or volume side by side.
#include "render/shaders/frame.glsl"
#include "render/shaders/gbuffer.glsl"
#include "render/display_transform.glsl"

in vec2 uv;
layout(location = 0) out vec4 display;

#if defined(SHOW_ARRAY)
uniform sampler2DArray target;
#elif defined(SHOW_VOLUME)
uniform sampler3D target;
#else
uniform sampler2D target;
#endif
uniform int layers;

// The target at this pixel; layers fill a square from its top left.
vec4 shown_texel() {
#if defined(SHOW_ARRAY) || defined(SHOW_VOLUME)
    int side = int(ceil(sqrt(float(layers))));
    vec2 cell = vec2(uv.x, 1.0 - uv.y) * float(side);
    int layer = int(cell.y) * side + int(cell.x);
    if (layer >= layers) return vec4(0.0);
    vec2 at = vec2(fract(cell.x), 1.0 - fract(cell.y));
#ifdef SHOW_VOLUME
    return textureLod(target, vec3(at, (float(layer) + 0.5) / float(layers)), 0.0);
#else
    return textureLod(target, vec3(at, float(layer)), 0.0);
#endif
#else
    return textureLod(target, uv, 0.0);
#endif
}

void main() {
    vec4 value = shown_texel();
#if defined(SHOW_DEPTH) && !defined(SHOW_ARRAY)
    // distance along the view: white near, black far, one stop for each doubling
    float metres = frame.eye_near.w / max(value.x, 1e-9);
    vec3 colour = value.x > 0.0 ? vec3(clamp(1.0 - log2(metres / frame.eye_near.w) / 12.0, 0.02, 1.0)) : vec3(0.0);
#elif defined(SHOW_DEPTH) || defined(SHOW_GREY)
    vec3 colour = value.xxx;
#elif defined(SHOW_NORMAL)
    vec3 colour = value.w + value.x > 0.0 ? decode_octahedral(value.xy) * 0.5 + 0.5 : vec3(0.0);
#elif defined(SHOW_RADIANCE)
    vec3 colour = ocio_display(vec4(value.rgb * frame.tan_half_fov_exposure.z, 1.0)).rgb;
#else
    vec3 colour = value.rgb;
#endif
    display = vec4(clamp(colour, 0.0, 1.0), 1.0);
}
