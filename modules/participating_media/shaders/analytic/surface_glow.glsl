// Provider of the indirect-light seam: what even fog around point lights sends onto surfaces (analytic/surface_glow.h).
#include "participating_media/media_kinds.glsl"
#include "render/shaders/seam_types.glsl"

#ifndef MEDIA_SURFACE_GLOW
IndirectLight participating_media_surface_glow(vec3 p, vec3 n, vec3 v, float roughness) {
    return IndirectLight(vec3(0.0), vec3(0.0));
}
#else
#include "participating_media/media.glsl"

uniform int glow_lamp_count;
uniform vec4 glow_lamps[32];        // xyz position in the world, w medium
uniform vec3 glow_intensities[32];  // cd
uniform sampler3D glow_table;       // as GlowTable

float glow_at(float depth, float angle, float layer) {
    vec3 at = vec3(log(max(depth, 1e-3) * 1e3) / log(3e4) * 63.0, angle * 0.31830989 * 31.0, layer) + 0.5;
    return textureLod(glow_table, at / vec3(64.0, 32.0, 7.0), 0.0).r * exp(-depth);
}

// Of one lamp, for a direction about which a lobe stands: 0 the surface's own, cosine-weighted; above, by roughness.
vec3 glow_of(int lamp, vec3 p, vec3 about, float layer) {
    int medium = int(glow_lamps[lamp].w);
    vec3 to_lamp = glow_lamps[lamp].xyz - p;
    float metres = max(length(to_lamp), 1e-3);
    vec3 depth = media[medium].sigma_t.rgb * metres;
    float angle = acos(clamp(dot(to_lamp, about) / metres, -1.0, 1.0));
    return media[medium].sigma_s_phase.rgb * glow_intensities[lamp] / metres *
           vec3(glow_at(depth.r, angle, layer), glow_at(depth.g, angle, layer), glow_at(depth.b, angle, layer));
}

IndirectLight participating_media_surface_glow(vec3 p, vec3 n, vec3 v, float roughness) {
    IndirectLight light = IndirectLight(vec3(0.0), vec3(0.0));
    float layer = 1.0 + 5.0 * clamp((roughness - 0.2) / 0.8, 0.0, 1.0);
    for (int i = 0; i < glow_lamp_count; ++i) {
        float t0 = 0.0, t1 = 1e-3;
        if (!clip_to_medium(int(glow_lamps[i].w), p, n, t0, t1)) continue;  // a surface outside of the fog
        light.irradiance += glow_of(i, p, n, 0.0);
        light.specular += glow_of(i, p, reflect(-v, n), layer);
    }
    return light;
}
#endif
