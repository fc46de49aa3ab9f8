#ifndef TYNDALL_PHYSICS_UNITS
#define TYNDALL_PHYSICS_UNITS
#include "physics/constants.glsl"
/// Photometric units, as KHR_lights_punctual has them: candela for point and spot lights, lux for directional ones,
/// cd/m^2 for radiance.

/// Scene radiance to pixel value: 1 / (1.2 * 2^EV100) (Lagarde & de Rousiers 2014). A surface of 1.2 * 2^EV100 cd/m^2
/// becomes 1. Sunlit scenes have EV100 15, rooms 5..8.
FN float exposure_from_ev100(float ev100) { return 1.0f / (1.2f * exp2(ev100)); }

/// EV100 of a camera: log2(N^2 / t * 100 / S), with f-number N, shutter time t (s), ISO speed S.
FN float ev100_from_camera(float f_number, float shutter_s, float iso) {
    return log2(f_number * f_number / shutter_s * 100.0f / iso);
}

/// Candela of an isotropic point light of this many lumen.
FN float point_candela_from_lumen(float lumen) { return lumen * kInverseFourPi; }

/// Lux at this distance (m) from a light of this many candela, on a plane that faces it: I/d^2. Nearer than 1 cm
/// counts as 1 cm.
FN float point_irradiance(float candela, float metres) { return candela / max(metres * metres, 1e-4f); }

/// Luminance of linear Rec.709 colour.
FN float luminance_rec709(vec3 color) { return dot(color, vec3(0.2126f, 0.7152f, 0.0722f)); }

#endif
