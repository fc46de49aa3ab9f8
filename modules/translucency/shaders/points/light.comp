// Adds one light to the points.
#include "translucency/points/cloud.glsl"
#include "render/shaders/lights.glsl"
#include "seams/light_transmittance.glsl"

uniform uint light_index;

void main() {
    uint point = gl_GlobalInvocationID.x;
    if (point >= point_count) return;
    Piece piece = piece_at(point);
    vec3 to_light;
    vec3 irradiance = light_irradiance(light_index, piece.place, to_light);
    float cosine = clamp(dot(piece.normal, to_light), 0.0, 1.0);
    if (cosine <= 0.0 || irradiance == vec3(0.0)) return;
    irradiance *= light_transmittance(light_index, piece.place, piece.normal);
    float share = entering(cosine);
    vec3 leaving = irradiance * scale_at(point) * leaving_share(cosine) * enters_to_wander(piece.place);
    float entered = share * luminance_rec709(irradiance);
    // it begins to spread where it first collides
    vec3 collides = piece.place - (to_light - cosine * piece.normal) * first_path();
    vec4 place = imageLoad(node_places, node_texel(point));
    place.xyz = mix(place.xyz, collides, entered / max(place.w + entered, 1e-30));
#ifdef DIRECTIONS
    leaving *= slanted_scale(cosine);
    vec4 direction = imageLoad(node_directions, node_texel(point));
    vec3 refracted = refract(-to_light, piece.normal, 1.0 / interior_eta());
    direction.xyz = mix(direction.xyz, refracted, entered / max(place.w + entered, 1e-30));
    imageStore(node_directions, node_texel(point), direction);
#endif
    imageStore(node_places, node_texel(point), vec4(place.xyz, place.w + entered));
    imageStore(node_fluxes, node_texel(point), imageLoad(node_fluxes, node_texel(point)) + vec4(leaving * (share * piece.area), cosine * luminance_rec709(irradiance)));
}
