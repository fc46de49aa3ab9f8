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
};

SkinSurface skin_surface(float number) {
    int at = int(number);
    vec4 layer = texelFetch(skin_surfaces, ivec2(at, 0), 0);
    vec4 diffuse = texelFetch(skin_surfaces, ivec2(at, 1), 0);
    vec4 spread = texelFetch(skin_surfaces, ivec2(at, 2), 0);
    return SkinSurface(layer, diffuse.xyz, diffuse.w, spread.x, spread.y, spread.z, spread.w);
}
