// Takes the grain off what was marched: the mean over 5x5 neighbours of like distance, as wide as the blue-noise mask's
// errors, which cancel there.
uniform sampler2D marched;  // rgb radiance, a metres marched

out vec4 filtered;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(marched, 0) - 1;
    vec4 centre = texelFetch(marched, pixel, 0);
    float sharpness = 12.0 / max(centre.a, 1e-3);
    vec3 sum = vec3(0.0);
    float total = 0.0;
    for (int y = -2; y <= 2; ++y) {
        for (int x = -2; x <= 2; ++x) {
            vec4 texel = texelFetch(marched, clamp(pixel + ivec2(x, y), ivec2(0), last), 0);
            float weight = (3.0 - float(abs(x))) * (3.0 - float(abs(y))) * max(0.0, 1.0 - sharpness * abs(texel.a - centre.a));
            sum += weight * texel.rgb;
            total += weight;
        }
    }
    filtered = vec4(sum / total, centre.a);
}
