// How far each pixel's ray goes, before the solvers add to it.
#include "participating_media/march/ray.glsl"

out vec4 in_scatter;  // rgb radiance, a metres

void main() { in_scatter = vec4(0.0, 0.0, 0.0, pixel_metres(ivec2(gl_FragCoord.xy))); }
