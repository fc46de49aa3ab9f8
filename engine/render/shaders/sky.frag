// What lies behind everything.
#include "render/shaders/frame.glsl"
#include "seams/sky.glsl"

in vec2 uv;
layout(location = 0) out vec4 radiance;

void main() { radiance = vec4(sky_radiance(eye_ray(uv)), 1.0); }
