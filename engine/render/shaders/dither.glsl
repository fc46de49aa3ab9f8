// Noise that hides the steps of the display's 8 bits.
#include "render/shaders/frame.glsl"
#include "physics/sequences.glsl"

uniform float dither_amplitude;  // one step, or 0

// Triangular noise of +- 1 from a number in [0, 1).
float triangular(float u) {
    float t = 2.0 * u - 1.0;
    return sign(t) * (1.0 - sqrt(1.0 - abs(t)));
}

// Adds the noise of this pixel and frame; black stays black and white stays white.
vec3 dithered(vec3 encoded) {
    vec2 shift = vec2(5.588238 * frame.size_time.w);
    vec3 noise = vec3(triangular(interleaved_gradient_noise(gl_FragCoord.xy + shift)),
                      triangular(interleaved_gradient_noise(gl_FragCoord.xy + shift + vec2(31.0, 17.0))),
                      triangular(interleaved_gradient_noise(gl_FragCoord.xy + shift + vec2(67.0, 41.0))));
    vec3 room = min(encoded, 1.0 - encoded);
    return encoded + noise * min(vec3(dither_amplitude), room);
}
