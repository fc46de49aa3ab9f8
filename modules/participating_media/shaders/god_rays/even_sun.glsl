// What the sun scatters into a ray through an even medium that nothing shades, in closed form: the way from the point t of
// the ray to where the light came into the box is the least of three lines over t, so between the places where two
// of them meet the exponent is linear.
#include "participating_media/light_source.glsl"

/// Metres to the three planes through which light may have come in, as begin + slope t.
struct WayIn {
    vec3 begin;
    vec3 slope;
};

WayIn way_in(Ray ray, vec3 to_light) {
    vec3 o = medium_place(medium, ray.origin);
    vec3 d = mat3(media[medium].box_from_world) * ray.direction;
    vec3 l = mat3(media[medium].box_from_world) * to_light;
    bvec3 beside = lessThan(abs(l), vec3(1e-12));
    vec3 inverse = 1.0 / mix(l, vec3(1.0), beside);
    return WayIn(mix((0.5 * sign(l) - o) * inverse, vec3(1e9), beside), mix(-d * inverse, vec3(0.0), beside));
}

float metres_in(WayIn way, float t) {
    vec3 m = way.begin + way.slope * t;
    return max(min(m.x, min(m.y, m.z)), 0.0);
}

/// Integral of both transmittances over [a, b] of a ray that enters the medium at t0; the exponent is linear there.
vec3 linear_piece(WayIn way, float t0, float a, float b) {
    vec3 from = media[medium].sigma_t.rgb * (a - t0 + metres_in(way, a));
    vec3 to = media[medium].sigma_t.rgb * (b - t0 + metres_in(way, b));
    return exp(-min(from, to)) * mean_transmittance(abs(to - from)) * (b - a);
}

float meeting(float begin_a, float slope_a, float begin_b, float slope_b, float t0, float t1) {
    float difference = slope_a - slope_b;
    return abs(difference) < 1e-9 ? t0 : clamp((begin_b - begin_a) / difference, t0, t1);
}

/// Over the whole of [t0, t1], inside the medium from t0 on.
vec3 unshadowed_integral(WayIn way, float t0, float t1) {
    float xy = meeting(way.begin.x, way.slope.x, way.begin.y, way.slope.y, t0, t1);
    float yz = meeting(way.begin.y, way.slope.y, way.begin.z, way.slope.z, t0, t1);
    float zx = meeting(way.begin.z, way.slope.z, way.begin.x, way.slope.x, t0, t1);
    float first = min(xy, min(yz, zx)), last = max(xy, max(yz, zx));
    float middle = clamp(xy + yz + zx - first - last, first, last);
    return linear_piece(way, t0, t0, first) + linear_piece(way, t0, first, middle) + linear_piece(way, t0, middle, last) +
           linear_piece(way, t0, last, t1);
}
