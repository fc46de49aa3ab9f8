// Where a light's ray has entered a solid: the heterogeneous translucent shadow map is the engine's shadow map, whose
// depth says the place, and the solid's grid, which says the normal there.
#include "translucency/htsm/object.glsl"
#include "render/shaders/lights.glsl"
#include "seams/light_transmittance.glsl"

uniform sampler2DArray entry_depths;
uniform uint light_index;

/// Metres from p to what the light meets first on its way there; negative where p lies before it, and `seen` false where
/// no shadow map knows.
float metres_to_first(vec3 p, vec3 to_light, out bool seen) {
    seen = false;
    int count = shadow_view_count(light_index);
    if (count == 0 || solid.view.x == 0.0) return 0.0;
    ShadowView view;
    vec4 at;
    if (light_kind(light_index) == LIGHT_DIRECTIONAL) {
        int found = count;
        for (int i = count - 1; i >= 0; --i) {  // the finest is the first
            vec4 place = light_data(light_index).views[i].page_from_world * vec4(p, 1.0);
            vec4 rectangle = light_data(light_index).views[i].rectangle;
            if (clamp(place.xy, rectangle.xy, rectangle.zw) == place.xy) found = i;
        }
        if (found == count) return 0.0;
        view = light_data(light_index).views[found];
        at = view.page_from_world * vec4(p, 1.0);
    } else {
        view = shadow_view(light_index, -to_light);
        at = view.page_from_world * vec4(p, 1.0);
        if (at.w <= 0.0) return 0.0;
    }
    vec2 uv = clamp(at.xy / at.w, view.rectangle.xy, view.rectangle.zw);
    float depth = textureLod(entry_depths, vec3(uv, view.texel_page_fades.y), 0.0).x;
    if (depth <= 0.0) return 0.0;
    // along the ray, depth is (at.z + t z) / (at.w + t w)
    vec4 slope = view.page_from_world * vec4(to_light, 0.0);
    float per_metre = depth * slope.w - slope.z;
    if (abs(per_metre) < 1e-20) return 0.0;
    seen = true;
    return (at.z - depth * at.w) / per_metre;
}

/// Light that has come straight to a place inside, through the boundary.
struct Entry {
    vec3 place;       // where it entered
    vec3 travel;      // unit direction of travel inside
    vec3 irradiance;  // on a plane across that direction, just inside
    float amount;     // integral of the density along the way inside
};

Entry entry_toward(vec3 p) {
    Entry entry;
    vec3 to_light;
    light_distance(light_index, p, to_light);
    vec3 unit = unit_at(p), direction = unit_direction(to_light);
    float edge = way_out(unit, direction);
    bool seen;
    float metres = metres_to_first(p, to_light, seen);
    float last_inside;
    float voxel = solid.scale_voxel.w;
    // beyond the grid is another thing's shadow
    bool hidden = seen && metres > edge + voxel;
    metres = seen ? clamp(metres, 0.0, edge) : edge;
    entry.amount = density_along(unit, direction, metres, last_inside);
    if (!seen) metres = min(last_inside + 0.5 * metres / float(steps), metres);
    vec3 entered = unit + direction * metres;
    entry.place = p + to_light * metres;
    // what the light met first is this solid if some of it is there
    float here = textureLod(solid_grid, unit + direction * max(metres - 0.5 * voxel, 0.0), 0.0).g;
    float own = hidden ? 0.0 : seen ? clamp(here / kInsideAll, 0.0, 1.0) : 1.0;
    vec3 far_light;
    entry.irradiance = own * light_irradiance(light_index, entry.place, far_light);
    entry.irradiance *= light_transmittance(light_index, entry.place + to_light * (2.0 * voxel), vec3(0.0));
    entry.travel = -to_light;
    float eta = solid.scattering_eta.w;
    if (eta > 1.0) {
        vec3 normal = normal_near(entered, to_light);
        float cosine = clamp(dot(normal, to_light), 0.02, 1.0);
        float bent = sqrt(1.0 - (1.0 - cosine * cosine) / (eta * eta));
        // the refracted way to the same depth is shorter (Jensen et al. 2001), and the beam wider
        entry.amount *= cosine / bent;
        entry.irradiance *= (1.0 - fresnel_dielectric(cosine, eta)) * cosine / bent;
        vec3 refracted;
        if (refract_ray(-to_light, normal, 1.0 / eta, refracted)) entry.travel = refracted;
    }
    return entry;
}
