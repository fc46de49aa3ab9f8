// What of a light reaches places on a plane in the world, whatever the camera sees.
#include "render/shaders/frame.glsl"
#include "seams/light_transmittance.glsl"

uniform vec3 low;
uniform vec3 across;
uniform vec3 up;

out vec4 transmittance;

void main() {
    vec2 uv = gl_FragCoord.xy / frame.size_time.xy;
    transmittance = vec4(light_transmittance(0u, low + uv.x * across + uv.y * up, vec3(0.0)), 1.0);
}
