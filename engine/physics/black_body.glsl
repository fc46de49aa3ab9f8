#ifndef TYNDALL_PHYSICS_BLACK_BODY
#define TYNDALL_PHYSICS_BLACK_BODY
/// The glow of hot things.

/// Planck's law at a wavelength (m), relative: 1 / (exp(c2 / (wavelength T)) - 1).
FN float planck_occupation(float wavelength, float kelvin) {
    float x = min(0.014387769f / (wavelength * kelvin), 80.0f);
    return 1.0f / (exp(x) - 1.0f);
}

/// Radiance of a black body in cd/m2, Rec. 709 primaries, 0 below 400 K. Planck's law through the CIE 1931 observer as
/// Wyman et al. fit it ("Simple Analytic Approximations to the CIE XYZ Color Matching Functions", JCGT 2013), times 683
/// lm/W. The integral over wavelengths is a sum over six whose weights were fit to it: X and Y within 0.02 %, Z within
/// 0.2 %, from 800 to 12000 K. Colours outside of the primaries' gamut (blue below 1900 K) are cut off at 0.
FN vec3 black_body_radiance(float kelvin) {
    float t = max(kelvin, 1.0f);
    float a = planck_occupation(440e-9f, t);
    float b = planck_occupation(490e-9f, t);
    float c = planck_occupation(550e-9f, t);
    float d = planck_occupation(600e-9f, t);
    float e = planck_occupation(650e-9f, t);
    float f = planck_occupation(710e-9f, t);
    vec3 sum = a * vec3(5.79545e10f, -5.67126e10f, 4.03872e11f) + b * vec3(-9.55529e10f, 8.64356e10f, 8.19125e10f) +
               c * vec3(-1.99103e10f, 1.30129e11f, -1.56239e10f) + d * vec3(1.28352e11f, 5.83135e9f, -3.28837e9f) +
               e * vec3(2.74454e10f, -2.20764e9f, -2.82214e8f) + f * vec3(1.13906e8f, 4.19559e7f, -7.70078e6f);
    return kelvin < 400.0f ? vec3(0.0f) : max(sum, vec3(0.0f));
}

#endif
