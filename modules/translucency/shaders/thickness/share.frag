// Share of the light about a body that goes through it, by how thick it is about each pixel.
#include "render/shaders/frame.glsl"
#include "render/shaders/gbuffer.glsl"

uniform sampler2D scene_depth;
uniform sampler2D gbuffer_surface;
uniform float number;  // of the surface
uniform sampler3D thickness;
uniform mat4 grid_from_world;
uniform float grid_metres;  // of a unit of the thickness
uniform sampler2D passing;  // share of light that leaves beyond a distance, over the root of it over the farthest
uniform float farthest;     // metres
layout(location = 0) out vec4 quick_through;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (surface_number(texelFetch(gbuffer_surface, pixel, 0)) != number) discard;
    vec3 place = world_from_depth(gl_FragCoord.xy / frame.size_time.xy, texelFetch(scene_depth, pixel, 0).x);
    float metres = grid_metres * textureLod(thickness, (grid_from_world * vec4(place, 1.0)).xyz, 0.0).x;
    float column = sqrt(min(metres / farthest, 1.0)) * float(textureSize(passing, 0).x - 1);
    vec3 passes = texelFetch(passing, ivec2(int(column + 0.5), 0), 0).rgb;
    quick_through = vec4(passes / (1.0 + passes), 0.0);  // the other side has the rest
}
