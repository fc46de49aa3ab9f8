// What is known of a skin surface by its number: SkinTables of skin/shading_model.h.
uniform sampler2D skin_surfaces;

struct SkinSurface {
    vec4 layer;         // roughness of both lobes over the surface's, share of the second, 1 = Kelemen & Szirmay-Kalos
    vec3 flattened;     // share of the normal map that diffuse light does not see
    float response;     // layer of skin_responses
    float pre_scatter;  // power of the base colour that counts where light enters
    float profile;      // number of the profile, from 1 on; 0 = no skin
    float technique;
    float transmission;
    float mirror;        // strength of the mirror, 0..1
    float mirror_layer;  // of skin_mirrors
    float thickness;     // of the body: 0 = shadow maps say it, 1 = it is known for other light, 2 = for all
    vec3 limb;           // physics/profile_corrections.h
};

/// Of the light that leaves, what leaves at a cosine, over even light.
vec3 skin_limb(SkinSurface skin, float cosine) {
    return 1.0 + skin.limb * (0.5 - cosine * cosine);
}

SkinSurface skin_surface(float number) {
    int at = int(number);
    vec4 layer = texelFetch(skin_surfaces, ivec2(at, 0), 0);
    vec4 diffuse = texelFetch(skin_surfaces, ivec2(at, 1), 0);
    vec4 spread = texelFetch(skin_surfaces, ivec2(at, 2), 0);
    vec3 mirror = texelFetch(skin_surfaces, ivec2(at, 3), 0).xyz;
    vec3 limb = texelFetch(skin_surfaces, ivec2(at, 4), 0).xyz;
    return SkinSurface(layer, diffuse.xyz, diffuse.w, spread.x, spread.y, spread.z, spread.w, mirror.x, mirror.y,
                       mirror.z, limb);
}
