// Where a light's ray has entered a solid: the heterogeneous translucent shadow map is the engine's shadow map, whose
// depth says the place, and the solid's grid, which says the normal there.
#include "translucency/htsm/object.glsl"
#include "render/shaders/lights.glsl"
#include "seams/light_transmittance.glsl"
#include "translucency/paint.glsl"

uniform sampler2DArray entry_depths;
uniform uint light_index;

/// A look at the scene from the light, along a ray: its places are `base + t slope` in a page.
struct EntryView {
    vec4 base, slope;  // of the ray's origin and direction
    vec4 light;        // of the direction to the light, or of the place of one that has a place
    vec4 rectangle;
    float page;  // below 0: no map knows
};

EntryView entry_view_of(ShadowView view, vec3 p, vec3 direction) {
    vec4 light = light_kind(light_index) == LIGHT_DIRECTIONAL ? vec4(-light_data(light_index).direction_kind.xyz, 0.0)
                                                              : vec4(light_position(light_index), 1.0);
    mat4 map = view.page_from_world;
    return EntryView(map * vec4(p, 1.0), map * vec4(direction, 0.0), map * light, view.rectangle, view.texel_page_fades.y);
}

/// The view that holds p: the finest of a directional light's, the face of a point light's.
EntryView entry_view(vec3 p, vec3 direction) {
    EntryView none;
    none.base = none.slope = none.light = none.rectangle = vec4(1.0);
    none.page = -1.0;
    int count = shadow_view_count(light_index);
    if (count == 0 || solid.voxel_cast.y == 0.0) return none;
    if (light_kind(light_index) == LIGHT_DIRECTIONAL) {
        EntryView found = none;
        for (int i = count - 1; i >= 0; --i) {
            EntryView view = entry_view_of(light_data(light_index).views[i], p, direction);
            if (clamp(view.base.xy, view.rectangle.xy, view.rectangle.zw) == view.base.xy) found = view;
        }
        return found;
    }
    vec3 to_light;
    light_distance(light_index, p, to_light);
    EntryView view = entry_view_of(shadow_view(light_index, -to_light), p, direction);
    if (view.base.w <= 0.0) return none;
    return view;
}

/// Metres from the place at t, toward the light, which is `distance_m` away, to what the light meets first there; below
/// 0 where that lies behind the place; `seen` false where no map knows.
float metres_to_first(EntryView view, float t, float distance_m, out bool seen) {
    vec4 at = view.base + t * view.slope;
    vec2 uv = clamp(at.xy / at.w, view.rectangle.xy, view.rectangle.zw);
    float depth = textureLod(entry_depths, vec3(uv, max(view.page, 0.0)), 0.0).x;
    vec4 toward = light_kind(light_index) == LIGHT_DIRECTIONAL ? view.light : (view.light - at) / distance_m;
    // toward the light depth is (at.z + s toward.z) / (at.w + s toward.w)
    float per_metre = depth * toward.w - toward.z;
    seen = view.page >= 0.0 && depth > 0.0 && abs(per_metre) > 1e-20;
    return seen ? (at.z - depth * at.w) / per_metre : 0.0;
}

/// Light that has come straight to a place inside, through the boundary.
struct Entry {
    vec3 travel;      // unit direction of travel inside
    vec3 irradiance;  // on a plane across that direction, just inside
    float amount;     // integral of the density along the way inside; before the boundary it goes on below 0
};

/// To the place at t of the ray from `p`, which `view` looks at, in `count` steps.
Entry entry_toward(EntryView view, vec3 p, vec3 direction, float t, int count) {
    vec3 place = p + t * direction, to_light;
    float distance_m = light_distance(light_index, place, to_light);
    if (light_kind(light_index) != LIGHT_DIRECTIONAL && shadow_view_count(light_index) > 1) {  // a face each
        view = entry_view(place, direction);
        t = 0.0;
    }
    vec3 unit = unit_at(place), toward = unit_direction(to_light);
    float edge = way_out(unit, toward), voxel = solid.voxel_cast.x;
    bool seen;
    float first = metres_to_first(view, t, distance_m, seen);
    float metres = seen ? clamp(first, 0.0, edge) : edge;
    // what the light met first is this solid if some of it is there; beyond the grid it is another thing
    float here = inside_at(unit + toward * clamp(first - 0.5 * voxel, -2.0 * voxel, edge));
    float own = !seen ? 1.0 : first > edge + voxel ? 0.0 : clamp(here / kInsideAll, 0.0, 1.0);
    Entry entry;
    entry.amount = density_along(unit, toward, metres, count);
    if (seen && first < 0.0) entry.amount = max(first, -2.0 * voxel) * density_at(unit + toward * max(first - voxel, -3.0 * voxel));
    vec3 ignored;
    entry.irradiance = own * light_irradiance(light_index, place, ignored);  // it goes on spreading inside
    entry.irradiance *= enters_past_paint(place + metres * to_light);
    entry.travel = -to_light;
#ifdef BENDS
    float eta = solid.scattering_eta.w;
    vec3 normal = normal_near(unit + toward * metres, to_light);
    float cosine = clamp(dot(normal, to_light), 0.02, 1.0);
    float bent = sqrt(1.0 - (1.0 - cosine * cosine) / (eta * eta));
    // the refracted way to the same depth is shorter (Jensen et al. 2001), and the beam wider
    entry.amount *= cosine / bent;
    entry.irradiance *= (1.0 - fresnel_dielectric(cosine, eta)) * cosine / bent;
    vec3 refracted;
    if (refract_ray(-to_light, normal, 1.0 / eta, refracted)) entry.travel = refracted;
#endif
    return entry;
}

/// What is left of the light where it enters the solid near p, of media and other things on its way: once a pixel.
vec3 left_at_entry(EntryView view, vec3 p) {
    vec3 to_light;
    float distance_m = light_distance(light_index, p, to_light);
    bool seen;
    float metres = metres_to_first(view, 0.0, distance_m, seen);
    // the solid's own shadow has been counted: outside of its grid there is only that of other things
    float edge = way_out(unit_at(p), unit_direction(to_light)) + solid.voxel_cast.x;
    if (!seen || metres < edge) metres = edge;
    return light_transmittance(light_index, p + to_light * (metres + 2.0 * solid.voxel_cast.x), vec3(0.0));
}
