// The pixels where a solid is seen, and how light leaves it there. BENDS is defined where the boundary refracts.
#include "physics/fresnel.glsl"
#include "render/shaders/frame.glsl"
#include "render/shaders/gbuffer.glsl"
#include "render/shaders/specular_table.glsl"

uniform sampler2D scene_depth;
uniform sampler2D gbuffer_normal;
uniform sampler2D gbuffer_surface;
uniform float number;
uniform vec4 boundary_base;    // rgb, index of refraction
uniform vec4 boundary_mirror;  // rgb specular colour, weight

/// What is seen at the pixel.
struct Seen {
    vec3 place;
    vec3 normal;
    vec3 inward;   // unit direction of the eye's ray inside
    float leaves;  // radiance outside over radiance inside
    vec3 scale;    // irradiance that makes the compose pass give this radiance
};

/// False where it is not. `eta` is the index of refraction.
bool seen_here(float eta, out Seen seen) {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (surface_number(texelFetch(gbuffer_surface, pixel, 0)) != number) return false;
    float depth = texelFetch(scene_depth, pixel, 0).x;
    LitPoint point = decode_lit_point(texelFetch(gbuffer_normal, pixel, 0));
    vec2 uv = gl_FragCoord.xy / frame.size_time.xy;
    vec3 ray = eye_ray(uv);
    float cosine = standard_nov(point.normal, -ray);
    seen.place = world_from_depth(uv, depth);
    seen.normal = point.normal;
    seen.inward = ray;
    seen.leaves = 1.0;
#ifdef BENDS
    vec3 bent;
    seen.inward = refract_ray(ray, point.normal, 1.0 / eta, bent) ? bent : -point.normal;
    seen.leaves = (1.0 - fresnel_dielectric(cosine, eta)) / (eta * eta);
#endif
    StandardMaterial boundary = standard_material(boundary_base.rgb, 0.0, boundary_base.w, boundary_mirror.w, boundary_mirror.rgb);
    vec2 table = specular_table_at(cosine, point.roughness);
    vec3 base = boundary.base_color * (vec3(1.0) - standard_specular_albedo(boundary.f0, boundary.f90, table));
    seen.scale = kPi / max(base, vec3(1e-4));
    return true;
}
