#ifndef TYNDALL_PHYSICS_INTERSECT
#define TYNDALL_PHYSICS_INTERSECT
#include "physics/constants.glsl"
/// Convex bounds of marches: each function narrows the interval [t0, t1] of the ray origin + t direction to what lies
/// inside and returns whether anything is left. Begin with [0, distance to the surface] and clip by one bound after
/// another; an origin inside and rays parallel to a side are no special cases for the caller. When nothing is left the
/// interval is undefined. `direction` is a unit vector.

/// Between the planes `low` and `high` of one axis; `o` and `d` are the ray's components on it.
FN bool clip_to_slab(float o, float d, float low, float high, INOUT(float) t0, INOUT(float) t1) {
    if (abs(d) < 1e-15f) return o >= low && o <= high && t0 < t1;
    float a = (low - o) / d;
    float b = (high - o) / d;
    t0 = max(t0, min(a, b));
    t1 = min(t1, max(a, b));
    return t0 < t1;
}

/// Inside the axis-aligned box.
FN bool clip_to_box(vec3 origin, vec3 direction, vec3 low, vec3 high, INOUT(float) t0, INOUT(float) t1) {
    return clip_to_slab(origin.x, direction.x, low.x, high.x, t0, t1) &&
           clip_to_slab(origin.y, direction.y, low.y, high.y, t0, t1) &&
           clip_to_slab(origin.z, direction.z, low.z, high.z, t0, t1);
}

/// Inside the sphere. Precise for spheres far away and small (Haines et al. 2019): measured from the point of the ray
/// nearest to the centre.
FN bool clip_to_sphere(vec3 origin, vec3 direction, vec3 center, float radius, INOUT(float) t0, INOUT(float) t1) {
    float nearest = dot(center - origin, direction);
    vec3 offset = origin + nearest * direction - center;
    float discriminant = radius * radius - dot(offset, offset);
    if (discriminant <= 0.0f) return false;
    float half_chord = sqrt(discriminant);
    t0 = max(t0, nearest - half_chord);
    t1 = min(t1, nearest + half_chord);
    return t0 < t1;
}

/// Inside the ball of radius 1/2 about the origin, the largest in the unit box. `direction` may have any length but 0: in
/// the local space of an ellipsoid t stays in metres.
FN bool clip_to_unit_ball(vec3 origin, vec3 direction, INOUT(float) t0, INOUT(float) t1) {
    float speed2 = max(dot(direction, direction), 1e-30f);
    float nearest = -dot(origin, direction) / speed2;
    vec3 offset = origin + nearest * direction;
    float half_chord = sqrt(max(0.25f - dot(offset, offset), 0.0f) / speed2);
    t0 = max(t0, nearest - half_chord);
    t1 = min(t1, nearest + half_chord);
    return t0 < t1;
}

/// Inside the front nappe of the infinite cone with this apex, unit axis and cosine of the half-angle, which lies
/// strictly between 0 and 1: a wider cone is not convex.
FN bool clip_to_infinite_cone(vec3 origin, vec3 direction, vec3 apex, vec3 axis, float cos_angle, INOUT(float) t0,
                              INOUT(float) t1) {
    // Inside: q(t) = (axis.x)^2 - cos^2 x.x = A t^2 + 2 B t + C >= 0 and axis.x > 0, t measured from the point of the
    // ray nearest to the apex.
    float nearest = dot(apex - origin, direction);
    vec3 offset = origin + nearest * direction - apex;
    float along = dot(axis, direction);
    float height = dot(axis, offset);
    float cos2 = cos_angle * cos_angle;
    float a = along * along - cos2;
    float b = along * height - cos2 * dot(offset, direction);
    float c = height * height - cos2 * dot(offset, offset);
    if (abs(a) < 1e-7f) a = a < 0.0f ? -1e-7f : 1e-7f;  // parallel to a side line: the far root goes to the horizon
    float discriminant = b * b - a * c;
    if (discriminant <= 0.0f && a < 0.0f) return false;
    float root = sqrt(max(discriminant, 0.0f));
    float q = b < 0.0f ? root - b : -b - root;
    float r0 = q / a;
    float r1 = q == 0.0f ? 0.0f : c / q;
    float low = min(r0, r1);
    float high = max(r0, r1);
    if (a < 0.0f) {  // crosses one nappe
        if (height + along * 0.5f * (low + high) <= 0.0f) return false;
        t0 = max(t0, nearest + low);
        t1 = min(t1, nearest + high);
    } else if (along > 0.0f) {  // comes out of the back nappe, stays in the front one
        t0 = max(t0, nearest + high);
    } else {
        t1 = min(t1, nearest + low);
    }
    return t0 < t1;
}

/// Inside a spot light's cone up to its `range` (m, a sphere about the apex). Cones of half-angle 85 degrees and more
/// are bounded by the range alone.
FN bool clip_to_cone(vec3 origin, vec3 direction, vec3 apex, vec3 axis, float cos_outer, float range, INOUT(float) t0,
                     INOUT(float) t1) {
    if (!clip_to_sphere(origin, direction, apex, range, t0, t1)) return false;
    if (cos_outer < 0.0872f) return true;
    return clip_to_infinite_cone(origin, direction, apex, axis, cos_outer, t0, t1);
}

#endif
