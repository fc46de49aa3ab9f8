// One mip of a probe's map: the image averaged over the GGX lobe about each direction, seen along it, by filtered
// importance sampling (Krivanek & Colbert 2008).
#include "physics/ggx.glsl"
#include "physics/sampling.glsl"
#include "physics/sequences.glsl"
#include "physics/sh.glsl"
#include "render/shaders/probe_map.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D source;  // latitude-longitude, with mips
layout(rgba32f) writeonly uniform image2DArray map;
uniform int layer;
uniform int texels;
uniform float roughness;

const uint kSamples = 64u;

// The image about a direction, averaged over a solid angle in steradians.
vec3 source_radiance(vec3 direction, float solid_angle) {
    vec2 size = vec2(textureSize(source, 0));
    float sine = sqrt(max(1.0 - direction.y * direction.y, 1e-4));
    float texel_angle = kTwoPi / size.x * kPi / size.y * sine;
    float lod = max(0.5 * log2(solid_angle / texel_angle), 0.0);
    return textureLod(source, direction_to_equirect(direction), lod).rgb;
}

vec3 filtered(vec3 axis) {
    float alpha = square(roughness);
    vec3 sum = vec3(0.0);
    float weight = 0.0;
    for (uint i = 0u; i < kSamples; ++i) {
        vec2 xi = hammersley(i, kSamples) + vec2(0.5 / float(kSamples), 0.0);
        float cosine2 = (1.0 - xi.x) / (1.0 + (alpha * alpha - 1.0) * xi.x);
        vec3 h = to_frame(spherical_direction(sqrt(cosine2), kTwoPi * xi.y), axis);
        float noh = dot(axis, h);
        vec3 l = 2.0 * noh * h - axis;
        float nol = dot(axis, l);
        if (nol <= 0.0) continue;
        // density of l: D NoH / (4 VoH) with v = n
        float density = 0.25 * ggx_distribution(axis, h, alpha);
        sum += nol * source_radiance(l, 1.0 / (float(kSamples) * density));
        weight += nol;
    }
    return sum / weight;
}

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    vec3 axis = probe_direction_from_uv((vec2(at) + 0.5) / float(texels));
    vec3 value = roughness > 0.0 ? filtered(axis) : source_radiance(axis, 4.0 * kPi / float(texels * texels));
    imageStore(map, ivec3(at, layer), vec4(value, 1.0));
}
