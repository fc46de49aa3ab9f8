#ifndef TYNDALL_PHYSICS_RAMP
#define TYNDALL_PHYSICS_RAMP
/// Ramps of density: 0 on one side, 1 on the other, linear between.

/// From 0 at `from` to 1 at `to`, along the line between them; the step at `from` when they are the same place.
FN float linear_ramp(vec3 p, vec3 from, vec3 to) {
    vec3 along = to - from;
    return clamp(dot(p - from, along) / max(dot(along, along), 1e-20f), 0.0f, 1.0f);
}

/// From 0 within `inner` of the centre to 1 beyond `outer`; inner < outer.
FN float radial_ramp(vec3 p, vec3 center, float inner, float outer) {
    return clamp((length(p - center) - inner) / max(outer - inner, 1e-10f), 0.0f, 1.0f);
}

#endif
