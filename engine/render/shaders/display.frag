// Radiance to display values: exposure, OpenColorIO, dither.
#include "render/shaders/frame.glsl"
#include "render/shaders/dither.glsl"
#include "render/display_transform.glsl"

layout(location = 0) out vec4 encoded;

uniform sampler2D radiance;

void main() {
    vec3 exposed = texelFetch(radiance, ivec2(gl_FragCoord.xy), 0).rgb * frame.tan_half_fov_exposure.z;
    vec3 shown = clamp(ocio_display(vec4(exposed, 1.0)).rgb, 0.0, 1.0);
    encoded = vec4(dithered(shown), dot(shown, vec3(0.299, 0.587, 0.114)));
}
