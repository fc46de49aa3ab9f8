// How much of the light that has entered one side of a slab leaves the other, and how much enters.
#include "physics/standard_surface.glsl"
#include "skin/surfaces.glsl"

uniform sampler2D skin_through;           // a row of shares each: TransmissionTables
uniform sampler2D skin_through_surfaces;  // rows: world to the surface's box, -1..1; table, its reach, its width
uniform sampler2DArray skin_mirrors;      // oily_layer.h

/// Cosines up to this are on their way to nothing: there light arrives from the front.
const float SKIN_GRAZING = 0.2;

/// The surface's row in the table of shares.
struct SkinThrough {
    vec4 x, y, z;  // world to box
    int row;
    float per_reach;
    float width;
};

SkinThrough skin_through_surface(float number) {
    int at = int(number);
    vec4 table = texelFetch(skin_through_surfaces, ivec2(at, 3), 0);
    return SkinThrough(texelFetch(skin_through_surfaces, ivec2(at, 0), 0), texelFetch(skin_through_surfaces, ivec2(at, 1), 0),
                       texelFetch(skin_through_surfaces, ivec2(at, 2), 0), int(table.x), 1.0 / max(table.y, 1e-9), table.z);
}

/// Share through a slab of this thickness, squared metres.
vec3 skin_share(SkinThrough through, float thickness2) {
    int last = textureSize(skin_through, 0).x - 1;
    float u = min(sqrt(sqrt(thickness2) * through.per_reach), 1.0);
    return texelFetch(skin_through, ivec2(int(u * float(last) + 0.5), through.row), 0).rgb;
}

/// Of light that arrives at a cosine what enters, over that of even light.
float skin_enters(SkinSurface skin, float cosine, float roughness) {
    vec2 lookup = standard_table_coordinate(cosine, roughness, float(textureSize(skin_mirrors, 0).x));
    return mix(1.0, textureLod(skin_mirrors, vec3(lookup, skin.mirror_layer), 0.0).x, skin.mirror);
}
