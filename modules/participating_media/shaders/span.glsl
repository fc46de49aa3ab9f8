// The variable in which light volumes integrate along an eye ray: x from -1 where the span of the ray that is in the medium
// and in the light's volume begins, to 1 where it ends. Linear in x, what the light sends to the eye is nearly even:
//  - point and spot lights: equal angles seen from the light take out the inverse-square law (Kulla & Fajardo 2012);
//  - then equal shares of an exponential, fitted between the span's ends, take out most of the transmittance.
#include "render/shaders/lights.glsl"

/// Of one pixel. `scale` is 0 when there is nothing to integrate.
struct Span {
    float low, high;  // of the curve, see below
    float decay;      // of the transmittance along the curve
    float scale;
};

/// How the light lies to the ray.
struct Passing {
    float closest;   // metres on the ray to the point nearest to the light
    float distance;  // metres from there to the light
};

Passing passing_of(vec3 to_light, vec3 direction) {
#if LIGHT_KIND == 2  // LIGHT_DIRECTIONAL
    return Passing(0.0, 0.0);
#else
    float closest = dot(to_light, direction);
    return Passing(closest, max(length(to_light - closest * direction), 1e-3));
#endif
}

#if LIGHT_KIND == 2
float curve(Passing passing, float t) { return t; }
float uncurve(Passing passing, float v) { return v; }
float metres_along_curve(Passing passing, float t) { return 1.0; }
#else
float curve(Passing passing, float t) { return atan((t - passing.closest) / passing.distance); }
float uncurve(Passing passing, float v) { return passing.closest + passing.distance * tan(v); }
float metres_along_curve(Passing passing, float t) {
    float offset = t - passing.closest;
    return (passing.distance * passing.distance + offset * offset) / passing.distance;
}
#endif

/// `fall` is by how many e-foldings the transmittance is smaller at the span's end than at its begin.
Span make_span(Passing passing, float t0, float t1, float fall) {
    Span span = Span(curve(passing, t0), curve(passing, t1), 0.0, 0.0);
    fall = clamp(fall, -8.0, 8.0);
    fall = abs(fall) < 0.01 ? 0.01 : fall;
    span.decay = fall / max(span.high - span.low, 1e-9);
    span.scale = 2.0 / (1.0 - exp(-fall));
    return span;
}

float to_parameter(Span span, Passing passing, float t) {
    float v = clamp(curve(passing, t), span.low, span.high);
    return clamp((1.0 - exp(-span.decay * (v - span.low))) * span.scale - 1.0, -1.0, 1.0);
}

/// The ray's t at x, and the metres of it that x covers there.
float from_parameter(Span span, Passing passing, float x, out float metres_per_x) {
    float left = 1.0 - (x + 1.0) / span.scale;
    float t = uncurve(passing, span.low - log(left) / span.decay);
    metres_per_x = metres_along_curve(passing, t) / (span.scale * span.decay * left);
    return t;
}
