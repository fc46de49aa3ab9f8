// What paint does to light that goes in and out of a body (paint/paint_grid.h): the one place that says it, for all
// techniques. What leaves is seen to by paint/mix.comp, from all of them.
uniform sampler3D paint_ends;  // what the kernel is multiplied by at both ends; open share of the surface
uniform sampler3D paint_even;  // what leaves of even light
uniform mat4 paint_from_world;

vec4 paint_ends_at(vec3 place) { return textureLod(paint_ends, (paint_from_world * vec4(place, 1.0)).xyz, 0.0); }

/// Share that enters at a place in the world, to be multiplied by what would enter without paint.
float enters_past_paint(vec3 place) { return paint_ends_at(place).a; }
/// The same, of light that scatters often and leaves elsewhere.
vec3 enters_to_wander(vec3 place) {
    vec4 ends = paint_ends_at(place);
    return ends.rgb * ends.a;
}
/// Of light that is taken to leave where it entered, the share that leaves.
vec3 leaves_past_paint(vec3 place) { return textureLod(paint_even, (paint_from_world * vec4(place, 1.0)).xyz, 0.0).rgb; }
/// The same over what mix.comp multiplies by, where other light has come from elsewhere.
vec3 leaves_where_it_enters(vec3 place) { return leaves_past_paint(place) / max(paint_ends_at(place).rgb, vec3(1e-6)); }
