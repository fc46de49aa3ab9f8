// Adds what of one light has come through skin of known thickness to the light buffer.
#include "skin/transmission/slab.glsl"
#include "render/shaders/lights.glsl"
#include "seams/light_transmittance.glsl"

uniform uint light_index;
layout(location = 0) out vec4 light_diffuse;

void main() {
    SkinSlab slab = skin_slab();
    vec3 to_light;
    vec3 irradiance = light_irradiance(light_index, slab.entry, to_light);
    float cosine = max(-dot(slab.normal, to_light), 0.0);
    vec3 arriving = irradiance * light_transmittance(light_index, slab.entry, -slab.normal) * cosine;
    float enters = skin_enters(slab.skin, cosine, slab.roughness) * smoothstep(0.0, SKIN_GRAZING, cosine);
    light_diffuse = vec4(arriving * slab.share * enters, 0.0);
}
