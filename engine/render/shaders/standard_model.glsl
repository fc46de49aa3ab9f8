// The shading model "standard" (number 0): physics/standard_surface.glsl.
#include "render/shaders/seam_types.glsl"

LightTerms standard_shading_model(ShadingPoint s, LightSample l) {
    return standard_light(s.normal, s.view, l.direction_to_light, s.roughness, l.irradiance);
}
