// A cloud of points (points/point_cloud.h) and its light, as the passes keep them. Nodes: the points, then the tree's
// levels.
#include "translucency/interior.glsl"

// A work group has a cluster of 64 points.
#ifdef POINTS_A_THREAD
layout(local_size_x = 64 / POINTS_A_THREAD) in;
#else
layout(local_size_x = 64) in;
#endif

// All lies in textures: of the ways to read it this is the quickest where a processor renders.
//  places: world, the middle of the light that entered; w: of points luminance of what entered, of
//   groups the variance of its place along an axis of the surface, m2
//  fluxes: rgb flux that has entered and leaves somewhere, lm; of points w: illuminance that arrived
#ifndef NODES_READ
layout(rgba32f) uniform image2D node_places;
layout(rgba32f) uniform image2D node_fluxes;
#ifdef DIRECTIONS
layout(rgba32f) uniform image2D node_directions;
#endif
#else
uniform sampler2D node_places;
uniform sampler2D node_fluxes;
uniform sampler2D node_directions;
#endif
//  directions (DIRECTIONS alone): mean of the unit vectors along which light enters, refracted; w: the mean normal
#include "translucency/directions.glsl"
const uint kNodeColumns = 256u;
ivec2 node_texel(uint node) { return ivec2(node % kNodeColumns, node / kNodeColumns); }

uniform sampler2D pieces;  // two texels a point: place, area; normal. Of the mesh's own space
#ifdef SCALES_WRITTEN
layout(rgba32f) uniform image2D point_scales;  // rgb what the kernel is multiplied by at both ends (balance.comp)
vec3 scale_at(uint point) { return imageLoad(point_scales, node_texel(point)).rgb; }
#else
uniform sampler2D point_scales;
vec3 scale_at(uint point) { return texelFetch(point_scales, node_texel(point), 0).rgb; }
#endif
uniform uint point_count;
uniform mat4 world_from_local;
uniform mat3 areas_from_local;  // cofactors: they turn an area's vector as the matrix turns its sides

/// The piece of surface that a point stands for, in the world.
struct Piece {
    vec3 place;
    vec3 normal;
    float area;  // m2
};

Piece piece_at(uint point) {
    vec4 place_area = texelFetch(pieces, node_texel(2u * point), 0);
    vec3 turned = areas_from_local * texelFetch(pieces, node_texel(2u * point + 1u), 0).xyz;
    float scale = length(turned);
    return Piece((world_from_local * vec4(place_area.xyz, 1.0)).xyz, turned / max(scale, 1e-20), place_area.w * scale);
}

