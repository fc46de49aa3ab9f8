#ifndef TYNDALL_PHYSICS_PHASE_SAMPLING
#define TYNDALL_PHYSICS_PHASE_SAMPLING
#include "physics/phase.glsl"
/// Cosines u drawn from the phase functions: the density of the direction is the phase function itself.
/// `direction_about(w_l, u, xi)` of sampling.glsl makes a direction of one.

/// Inverts the distribution of Henyey-Greenstein; written without the usual division by g, so g = 0 is no special case.
FN float sample_henyey_greenstein(float xi, float g) {
    float s = 2.0f * xi - 1.0f;
    float numerator = 2.0f * s + g * (s * s + 3.0f) + 2.0f * g * g * s + g * g * g * (s * s - 1.0f);
    return clamp(numerator / (2.0f * square(1.0f + g * s)), -1.0f, 1.0f);
}

/// Inverts the distribution of Schlick's lobe.
FN float sample_schlick(float xi, float k) {
    return clamp((2.0f * xi - 1.0f + k) / (1.0f - k + 2.0f * k * xi), -1.0f, 1.0f);
}

/// Inverts Rayleigh's cubic (Frisvad 2011), by the root that does not cancel.
FN float sample_rayleigh(float xi) {
    float q = 4.0f * abs(xi - 0.5f);
    float a = pow(q + sqrt(q * q + 1.0f), 1.0f / 3.0f);
    float u = min(a - 1.0f / a, 1.0f);
    return xi < 0.5f ? -u : u;
}

/// Share of the u^2-weighted Henyey-Greenstein lobe below its sample at s = 2 xi - 1: integral of u^2 d(xi).
/// Closed form for |g| > 0.2, four-point Gauss-Legendre below, where the closed form cancels.
FN float henyey_greenstein_second_moment_below(float s, float g) {
    if (abs(g) < 0.2f) {
        float h = 0.5f * (s + 1.0f);
        float a = sample_henyey_greenstein(h * 0.0694318442f, g);
        float b = sample_henyey_greenstein(h * 0.3300094782f, g);
        float c = sample_henyey_greenstein(h * 0.6699905218f, g);
        float d = sample_henyey_greenstein(h * 0.9305681558f, g);
        return h * (0.1739274226f * (a * a + d * d) + 0.3260725774f * (b * b + c * c));
    }
    float g2 = g * g;
    float c = 1.0f + g2;
    float r = (1.0f - g2) / (1.0f + g * s);  // distance sqrt(1 + g^2 - 2 g u) of the sample
    float r1 = 1.0f + g;                     // and of u = -1
    float primitive = c * c * (1.0f / r - 1.0f / r1) + (r - r1) * (2.0f * c - (r * r + r * r1 + r1 * r1) / 3.0f);
    return (1.0f - g2) / (8.0f * g2 * g) * primitive;
}

/// Inverts the distribution of Draine's function by Newton steps kept inside a bracket; error in xi below 2e-5.
FN float sample_draine(float xi, float g, float a) {
    float scale = 1.0f / (1.0f + a * (1.0f + 2.0f * g * g) / 3.0f);
    float low = 0.0f;
    float high = 1.0f;
    float eta = xi;  // the quantile of the Henyey-Greenstein lobe that is looked for
    for (int i = 0; i < 24; ++i) {
        float u = sample_henyey_greenstein(eta, g);
        float error = scale * (eta + a * henyey_greenstein_second_moment_below(2.0f * eta - 1.0f, g)) - xi;
        if (abs(error) < 1e-6f) break;
        if (error > 0.0f) {
            high = eta;
        } else {
            low = eta;
        }
        eta -= error / (scale * (1.0f + a * u * u));
        if (eta <= low || eta >= high) eta = 0.5f * (low + high);
    }
    return sample_henyey_greenstein(eta, g);
}

/// A cosine from the phase function of this kind; `xi.y` chooses the lobe where there are two.
FN float phase_sample(int kind, vec4 parameters, vec2 xi) {
    switch (kind) {
        case PHASE_RAYLEIGH: return sample_rayleigh(xi.x);
        case PHASE_HENYEY_GREENSTEIN: return sample_henyey_greenstein(xi.x, parameters.x);
        case PHASE_SCHLICK: return sample_schlick(xi.x, parameters.x);
        case PHASE_CORNETTE_SHANKS: return sample_draine(xi.x, parameters.x, 1.0f);
        case PHASE_TWO_LOBE: return sample_henyey_greenstein(xi.x, xi.y < parameters.z ? parameters.y : parameters.x);
        case PHASE_DRAINE: return sample_draine(xi.x, parameters.x, parameters.y);
        case PHASE_MIE_DROPLETS:
            if (xi.y < parameters.w) return sample_draine(xi.x, parameters.y, parameters.z);
            return sample_henyey_greenstein(xi.x, parameters.x);
        default: return 2.0f * xi.x - 1.0f;
    }
}

#endif
