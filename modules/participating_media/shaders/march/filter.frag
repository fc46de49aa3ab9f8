// Takes the grain off what was marched: the mean over neighbours of like distance, RADIUS pixels on each side. The errors
// of the blue-noise mask cancel over few pixels.
uniform sampler2D marched;  // rgb radiance, a metres marched

out vec4 filtered;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(marched, 0) - 1;
    vec4 centre = texelFetch(marched, pixel, 0);
    float sharpness = 12.0 / max(centre.a, 1e-3);
    vec3 sum = vec3(0.0);
    float total = 0.0;
    for (int y = -RADIUS; y <= RADIUS; ++y) {
        for (int x = -RADIUS; x <= RADIUS; ++x) {
            vec4 texel = texelFetch(marched, clamp(pixel + ivec2(x, y), ivec2(0), last), 0);
            float weight = (float(RADIUS + 1) - float(abs(x))) * (float(RADIUS + 1) - float(abs(y))) * max(0.0, 1.0 - sharpness * abs(texel.a - centre.a));
            sum += weight * texel.rgb;
            total += weight;
        }
    }
    filtered = vec4(sum / total, centre.a);
}
