#ifndef TYNDALL_PHYSICS_PHASE
#define TYNDALL_PHYSICS_PHASE
#include "physics/constants.glsl"
/// Phase functions, in 1/sr: each integrates to 1 over the sphere.
///
/// `u = dot(w_l, w_o)` with w_l the direction the light TRAVELS and w_o the direction from the point to the eye:
/// u = 1 is forward scattering, g > 0 scatters forward. |g| and |k| must stay below 1.

/// Equal in all directions.
FN float phase_isotropic() { return kInverseFourPi; }

/// Molecules, much smaller than the wavelength (Rayleigh 1871). Mean cosine 0.
FN float phase_rayleigh(float u) { return 0.75f * kInverseFourPi * (1.0f + u * u); }

/// 1 + g^2 - 2 g u, without the cancellation near |g| = 1.
FN float henyey_greenstein_base(float u, float g) {
    float a = abs(g);
    return square(1.0f - a) + 2.0f * a * (1.0f - (g < 0.0f ? -u : u));
}

/// Henyey & Greenstein 1941: one lobe with mean cosine g.
FN float phase_henyey_greenstein(float u, float g) {
    float base = henyey_greenstein_base(u, g);
    return kInverseFourPi * (1.0f - g) * (1.0f + g) / (base * sqrt(base));
}

/// Schlick's rational lobe (Blasi et al. 1993), cheaper than Henyey-Greenstein: no root.
FN float phase_schlick(float u, float k) { return kInverseFourPi * (1.0f - k) * (1.0f + k) / square(1.0f - k * u); }

/// The k whose Schlick lobe resembles Henyey-Greenstein's of mean cosine g: 1.55 g - 0.55 g^3.
FN float schlick_k_from_g(float g) { return 1.55f * g - 0.55f * g * g * g; }

/// Mean cosine of Schlick's lobe: 1/k - (1-k^2)/(2 k^2) ln((1+k)/(1-k)), by its series for small k.
FN float schlick_mean_cosine(float k) {
    float k2 = k * k;
    if (k2 < 0.04f) {
        return (1.0f - k2) * k *
               (0.66666667f + k2 * (0.8f + k2 * (0.85714286f + k2 * (0.88888889f + k2 * 0.90909091f))));
    }
    return 1.0f / k - (1.0f - k2) / (2.0f * k2) * log((1.0f + k) / (1.0f - k));
}

/// Draine 2003: Henyey-Greenstein times (1 + a u^2); a = 0 is Henyey-Greenstein, a = 1 is Cornette-Shanks.
FN float phase_draine(float u, float g, float a) {
    return phase_henyey_greenstein(u, g) * (1.0f + a * u * u) / (1.0f + a * (1.0f + 2.0f * g * g) / 3.0f);
}

/// Mean cosine of Draine's function.
FN float draine_mean_cosine(float g, float a) {
    float g2 = g * g;
    return g * (1.0f + a * (3.0f + 2.0f * g2) / 5.0f) / (1.0f + a * (1.0f + 2.0f * g2) / 3.0f);
}

/// Cornette & Shanks 1992: tends to Rayleigh's function as g tends to 0.
FN float phase_cornette_shanks(float u, float g) { return phase_draine(u, g, 1.0f); }

/// Mean cosine of Cornette-Shanks.
FN float cornette_shanks_mean_cosine(float g) { return draine_mean_cosine(g, 1.0f); }

/// Two Henyey-Greenstein lobes; `weight` is the share of the second. Mean cosine mix(g0, g1, weight).
FN float phase_two_lobe(float u, float g0, float g1, float weight) {
    return mix(phase_henyey_greenstein(u, g0), phase_henyey_greenstein(u, g1), weight);
}

/// Water droplets: Henyey-Greenstein and Draine lobes. `fit` = (g_hg, g_draine, a, weight) from `mie_droplet_fit`.
FN float phase_mie_droplets(float u, vec4 fit) {
    return mix(phase_henyey_greenstein(u, fit.x), phase_draine(u, fit.y, fit.z), fit.w);
}

/// Parameters of `phase_mie_droplets` for fog and cloud droplets of this diameter, 5..50 micrometres
/// (Jendersie & d'Eon 2023).
FN vec4 mie_droplet_fit(float diameter_um) {
    float d = clamp(diameter_um, 5.0f, 50.0f);
    return vec4(exp(-0.0990567f / (d - 1.67154f)), exp(-2.20679f / (d + 3.91029f) - 0.428934f),
                exp(3.62489f - 8.29288f / (d + 5.52825f)), exp(-0.599085f / (d - 0.641583f) - 0.665888f));
}

/// What a medium stores: a kind and four numbers.
const int PHASE_ISOTROPIC = 0;          ///< no parameters
const int PHASE_RAYLEIGH = 1;           ///< no parameters
const int PHASE_HENYEY_GREENSTEIN = 2;  ///< x = g
const int PHASE_SCHLICK = 3;            ///< x = k (`schlick_k_from_g`)
const int PHASE_CORNETTE_SHANKS = 4;    ///< x = g
const int PHASE_TWO_LOBE = 5;           ///< x = g0, y = g1, z = weight of g1
const int PHASE_DRAINE = 6;             ///< x = g, y = a
const int PHASE_MIE_DROPLETS = 7;       ///< `mie_droplet_fit`
const int PHASE_COUNT = 8;

/// The phase function of this kind at u, 1/sr; 0 for a kind that does not exist.
FN float phase_evaluate(int kind, vec4 parameters, float u) {
    switch (kind) {
        case PHASE_ISOTROPIC: return phase_isotropic();
        case PHASE_RAYLEIGH: return phase_rayleigh(u);
        case PHASE_HENYEY_GREENSTEIN: return phase_henyey_greenstein(u, parameters.x);
        case PHASE_SCHLICK: return phase_schlick(u, parameters.x);
        case PHASE_CORNETTE_SHANKS: return phase_cornette_shanks(u, parameters.x);
        case PHASE_TWO_LOBE: return phase_two_lobe(u, parameters.x, parameters.y, parameters.z);
        case PHASE_DRAINE: return phase_draine(u, parameters.x, parameters.y);
        case PHASE_MIE_DROPLETS: return phase_mie_droplets(u, parameters);
        default: return 0.0f;
    }
}

/// Its mean cosine: the g of similarity theory, sigma_s' = sigma_s (1 - g).
FN float phase_mean_cosine(int kind, vec4 parameters) {
    switch (kind) {
        case PHASE_HENYEY_GREENSTEIN: return parameters.x;
        case PHASE_SCHLICK: return schlick_mean_cosine(parameters.x);
        case PHASE_CORNETTE_SHANKS: return cornette_shanks_mean_cosine(parameters.x);
        case PHASE_TWO_LOBE: return mix(parameters.x, parameters.y, parameters.z);
        case PHASE_DRAINE: return draine_mean_cosine(parameters.x, parameters.y);
        case PHASE_MIE_DROPLETS: return mix(parameters.x, draine_mean_cosine(parameters.y, parameters.z), parameters.w);
        default: return 0.0f;
    }
}

#endif
