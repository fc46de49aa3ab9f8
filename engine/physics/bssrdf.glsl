#ifndef TYNDALL_PHYSICS_BSSRDF
#define TYNDALL_PHYSICS_BSSRDF
#include "physics/constants.glsl"
#include "physics/fresnel.glsl"
/// Light that enters a translucent solid at one place and leaves it at another, by models of diffusion.
///
/// Each model gives the radiant exitance at a place per flux that has entered at another, 1/m2: the light that has passed
/// the boundary inward (1 - F) is left to the caller, the boundary outward is in it. It leaves as
/// exitance * (1 - F(cosine, eta)) / (pi * diffuse_transmission(1 / eta)) in radiance. Lengths in metres.

/// Moments of the Fresnel reflectance, 2 C1 and 3 C2 (d'Eon & Irving 2011); `eta` = n_here / n_beyond of the side that the
/// light is on: for light inside a solid its own index.
FN float fresnel_moment_2c1(float eta) {
    if (eta < 1.0f)
        return 0.919317f + eta * (-3.4793f + eta * (6.75335f + eta * (-7.80989f + eta * (4.98554f - eta * 1.36881f))));
    return -9.23372f + eta * (22.2272f + eta * (-20.9292f + eta * (10.2291f + eta * (-2.54396f + eta * 0.254913f))));
}
FN float fresnel_moment_3c2(float eta) {
    if (eta < 1.0f)
        return 0.828421f + eta * (-2.62051f + eta * (3.36231f + eta * (-1.95284f + eta * (0.236494f + eta * 0.145787f))));
    float inverse = 1.0f / eta;
    return -1641.1f + inverse * (1376.53f + inverse * (-656.175f + inverse * 135.926f)) +
           eta * (1213.67f + eta * (-568.556f + eta * (164.798f + eta * (-27.0181f + eta * 1.91826f))));
}
/// Share of diffuse light that passes a boundary, 1 - 2 C1.
FN float diffuse_transmission(float eta) { return 1.0f - fresnel_moment_2c1(eta); }

/// A solid as diffusion sees it, a channel each.
struct Diffusion {
    vec3 sigma_t;          ///< 1/m, not reduced
    vec3 sigma_t_reduced;  ///< 1/m: sigma_a + sigma_s (1 - g)
    vec3 albedo_reduced;   ///< sigma_s (1 - g) / sigma_t_reduced
    vec3 coefficient;      ///< D of classical diffusion, m
    vec3 sigma_tr;         ///< 1/m, with that
    float eta;             ///< index of refraction against the outside
    float c_phi;           ///< (1 - 2 C1) / 4
    float c_e;             ///< (1 - 3 C2) / 2
};

FN Diffusion make_diffusion(vec3 sigma_s, vec3 sigma_a, float g, float eta) {
    Diffusion m;
    vec3 sigma_s_reduced = sigma_s * (1.0f - g);
    m.sigma_t = max(sigma_s + sigma_a, vec3(1e-6f));
    m.sigma_t_reduced = max(sigma_s_reduced + sigma_a, vec3(1e-6f));
    m.albedo_reduced = sigma_s_reduced / m.sigma_t_reduced;
    m.coefficient = vec3(1.0f / 3.0f) / m.sigma_t_reduced;
    m.sigma_tr = sqrt(3.0f * sigma_a * m.sigma_t_reduced);
    m.eta = eta;
    m.c_phi = 0.25f * (1.0f - fresnel_moment_2c1(eta));
    m.c_e = 0.5f * (1.0f - fresnel_moment_3c2(eta));
    return m;
}

/// Flux through a plane from a source `depth` metres from it at a distance `d`, over the source's power.
FN vec3 dipole_flux(vec3 sigma_tr, vec3 depth, vec3 d) {
    return depth * (vec3(1.0f) + sigma_tr * d) * exp(-sigma_tr * d) / (4.0f * kPi * d * d * d);
}

/// Jensen et al. 2001 at `r` metres: the standard dipole.
FN vec3 standard_dipole(Diffusion m, float r) {
    float f = fresnel_diffuse_reflectance(m.eta);
    vec3 z_real = vec3(1.0f) / m.sigma_t_reduced;
    vec3 z_mirrored = z_real + 4.0f * ((1.0f + f) / (1.0f - f)) * m.coefficient;
    return m.albedo_reduced * (dipole_flux(m.sigma_tr, z_real, sqrt(z_real * z_real + r * r)) +
                               dipole_flux(m.sigma_tr, z_mirrored, sqrt(z_mirrored * z_mirrored + r * r)));
}

/// Grosjean's diffusion (d'Eon & Irving 2011): coefficient, transport coefficient, and the mirrored source's depth for a
/// real one at `z_real`.
FN vec3 grosjean_coefficient(Diffusion m) {
    return (vec3(2.0f) - m.albedo_reduced) / (3.0f * m.sigma_t_reduced);
}
FN vec3 grosjean_sigma_tr(Diffusion m) {
    return sqrt((vec3(1.0f) - m.albedo_reduced) * m.sigma_t_reduced / grosjean_coefficient(m));
}
FN vec3 grosjean_mirrored(Diffusion m, vec3 z_real) {
    return z_real + 4.0f * ((1.0f - m.c_e) / (2.0f * m.c_phi)) * grosjean_coefficient(m);
}

/// Exitance of a real source at `z_real` metres and its mirror image, both of power 1.
FN vec3 grosjean_dipole(Diffusion m, vec3 z_real, float r) {
    vec3 d = grosjean_coefficient(m);
    vec3 sigma_tr = grosjean_sigma_tr(m);
    vec3 z_mirrored = grosjean_mirrored(m, z_real);
    vec3 d_real = sqrt(z_real * z_real + r * r);
    vec3 d_mirrored = sqrt(z_mirrored * z_mirrored + r * r);
    vec3 fluence = (exp(-sigma_tr * d_real) / d_real - exp(-sigma_tr * d_mirrored) / d_mirrored) / (4.0f * kPi * d);
    return m.c_phi * fluence +
           m.c_e * (dipole_flux(sigma_tr, z_real, d_real) + dipole_flux(sigma_tr, z_mirrored, d_mirrored));
}

/// d'Eon 2012, "A Better Dipole".
FN vec3 better_dipole(Diffusion m, float r) {
    return m.albedo_reduced * m.albedo_reduced * grosjean_dipole(m, vec3(1.0f) / m.sigma_t_reduced, r);
}

/// Habel, Christensen & Jarosz 2013, photon beam diffusion for light along the normal: the multiple scattering of a beam,
/// `count` sources along it.
FN vec3 photon_beam_diffusion(Diffusion m, float r, int count) {
    vec3 sum = vec3(0.0f);
    for (int i = 0; i < count; ++i) {
        vec3 z = -log(1.0f - (float(i) + 0.5f) / float(count)) / m.sigma_t_reduced;
        vec3 near = vec3(1.0f) - exp(-2.0f * m.sigma_t_reduced * (sqrt(z * z + r * r) + z));
        sum += near * grosjean_dipole(m, z, r);
    }
    return m.albedo_reduced * m.albedo_reduced * sum / float(count);
}

/// Christensen & Burley 2015, normalised diffusion: what leaves a half-space of diffuse albedo `albedo` and mean free path
/// `mean_free_path` in all is that albedo. Singular at r = 0: r below 1e-9 counts as that.
FN vec3 normalised_diffusion(vec3 albedo, vec3 mean_free_path, float r) {
    vec3 s = vec3(1.9f) - albedo + 3.5f * (albedo - 0.8f) * (albedo - 0.8f);
    vec3 d = mean_free_path / s;
    r = max(r, 1e-9f);
    return albedo * (exp(-r / d) + exp(-r / (3.0f * d))) / (8.0f * kPi * r * d);
}

/// Frisvad, Hachisuka & Kjeldsen 2014: exitance of one source of the directional dipole, a channel each. `r2` is the
/// squared distance to where the light leaves (the model's own for the real one); `xw` and `xn` the way there along the way in which
/// the source sends light and along the normal where the light leaves, `wn` the cosine between these two.
FN vec3 directional_source(Diffusion m, vec3 r2, vec3 xw, vec3 xn, float wn) {
    vec3 nearness = inversesqrt(r2), nearness2 = nearness * nearness;
    vec3 s = m.sigma_tr * r2 * nearness, s1 = vec3(1.0f) + s, d3 = 3.0f * m.coefficient;
    vec3 fluence = r2 / m.coefficient + 3.0f * s1 * xw;
    vec3 slope = d3 * s1 * wn - (s1 + d3 * (3.0f * s1 + s * s) * nearness2 * xw) * xn;
    return exp(-s) * (nearness * nearness2 / (4.0f * kPi)) * (m.c_phi * fluence - m.c_e * slope);
}

/// The directional dipole: light that enters along the unit vector `w` (already refracted) where the unit normal is
/// `normal_in` and leaves `x` metres from there where it is `normal_out`. As published it returns up to twice as much light
/// as a half-space does, some materials more than enters.
FN vec3 directional_dipole(Diffusion m, vec3 x, vec3 w, vec3 normal_in, vec3 normal_out) {
    float r2 = dot(x, x), xw = dot(x, w), xn = dot(x, normal_out), wn = dot(w, normal_out);
    vec3 d_e = 2.131f * m.coefficient / sqrt(max(m.albedo_reduced, vec3(1e-4f)));
    // of the real source: what is seen from the lit side lies farther
    vec3 cos_beta = -sqrt(max(r2 - xw * xw, 0.0f)) * inversesqrt(vec3(r2) + d_e * d_e);
    vec3 lit = m.coefficient * wn * (m.coefficient * wn + 2.0f * d_e * cos_beta);
    vec3 back = vec3(1.0f) / (9.0f * m.sigma_t * m.sigma_t);
    vec3 real2 = max(vec3(r2) + (wn < 0.0f ? lit : back), vec3(1e-20f));
    // the plane that mirrors it holds x
    vec3 across = r2 * normal_in - dot(x, normal_in) * x;
    float l2 = dot(across, across);
    vec3 mirror = l2 > 1e-12f * r2 * r2 && r2 > 0.0f ? across * inversesqrt(l2) : normal_in;
    float xm = dot(x, mirror), wm = dot(w, mirror), mn = dot(mirror, normal_out);
    vec3 apart = ((1.0f - m.c_e) / m.c_phi) * d_e;  // of the two sources
    vec3 mirrored2 = max(vec3(r2) + apart * (apart - 2.0f * xm), vec3(1e-20f));
    vec3 xw_mirrored = vec3(xw - 2.0f * wm * xm) + apart * wm;
    return max(directional_source(m, real2, vec3(xw), vec3(xn), wn) -
                   directional_source(m, mirrored2, xw_mirrored, vec3(xn) - apart * mn, wn - 2.0f * wm * mn),
               vec3(0.0f));
}

#endif
