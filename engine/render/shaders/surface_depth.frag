// Depth alone; what is masked out leaves none.
#ifdef ALPHA_MASK
#include "render/shaders/material_maps.glsl"
#endif

void main() {
#ifdef ALPHA_MASK
    if (base_colour_at().a < material.metallic_roughness_occlusion_cutoff.w) discard;
#endif
}
