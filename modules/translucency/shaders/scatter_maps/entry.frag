// What of a light enters a solid where the light sees it: the subsurface scatter map.
#include "render/shaders/lights.glsl"
#include "seams/light_transmittance.glsl"
#include "translucency/scatter_maps/solid.glsl"
#include "translucency/light_view.glsl"

in vec3 v_place;
in vec3 v_normal;
layout(location = 0) out vec4 light;
layout(location = 1) out vec4 way;
layout(location = 2) out vec4 flux;

uniform uint light_index;
uniform sampler2D exits;

void main() {
    vec3 to_light, normal = normalize(v_normal);
    vec3 irradiance = light_irradiance(light_index, v_place, to_light) * light_transmittance(light_index, v_place, normal);
    float eta = solid.extinction.w, cosine = clamp(dot(normal, to_light), 0.02, 1.0);
    float bent = cosine_inside(cosine), enters = 1.0 - fresnel_dielectric(cosine, eta);
    vec3 at = light_place(v_place), travel = -to_light, refracted;
    if (eta > 1.0 && refract_ray(-to_light, normal, 1.0 / eta, refracted)) travel = refracted;
    float z = at.z - view.window.w;
    float thickness = max(-texelFetch(exits, ivec2(gl_FragCoord.xy), 0).x - z, 0.0) * slant(at);
    light = vec4(irradiance * enters * enters_past_paint(v_place), 1.0);
    // the refracted way to the same depth is shorter, and the beam wider, by the cosines (Jensen et al. 2001)
    way = vec4(travel * (cosine / bent), z);
    flux.rgb = irradiance * enters * multiple_share(cosine) * thin_scale(thickness) * enters_to_wander(v_place);
    flux.a = luminance_rec709(flux.rgb) * z;
}
