// Adds what of the light from all around has come through skin of known thickness to the light buffer.
#include "skin/transmission/slab.glsl"
#include "seams/indirect_light.glsl"

layout(location = 0) out vec4 light_diffuse;

void main() {
    SkinSlab slab = skin_slab();
    vec3 arriving = indirect_light(slab.entry, -slab.normal, -slab.normal, 1.0).irradiance;
    light_diffuse = vec4(arriving * slab.share, 0.0);
}
