// A texel of a light map and its place in the world.
#include "skin/texture_space/atlas.glsl"
#include "physics/standard_surface.glsl"
#include "render/shaders/frame.glsl"

layout(rgba32f) uniform image2D map;
layout(rgba32f) readonly uniform image2D places;
layout(rgba32f) readonly uniform image2D normals;
layout(rgba32f) readonly uniform image2D finish;
uniform mat4 world_from_local;
uniform mat3 normal_from_local;

struct Texel {
    vec3 place;
    vec3 normal;
    float curvature;  // 1/m
    ivec2 at;
    float chart;
};

Texel texel_at(uint entry) {
    vec4 place = imageLoad(places, list_texel(entry)), normal = imageLoad(normals, list_texel(entry));
    float longer = length(normal.xyz);  // by the curvature
    vec3 turned = normal_from_local * (normal.xyz / longer);
    float scale = length(turned);  // one over the transform's
    return Texel((world_from_local * vec4(place.xyz, 1.0)).xyz, turned / scale, (longer - 1.0) * scale,
                 map_texel(place.w), normal.w);
}
