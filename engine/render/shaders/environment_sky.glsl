// The sky seam's provider "sky": the scene's image or its plain radiance.
#include "physics/sh.glsl"

uniform vec3 sky_scale;
uniform bool sky_has_image;
uniform mat3 sky_image_from_world;
uniform sampler2D sky_image;

vec3 environment_sky(vec3 direction) {
    if (!sky_has_image) return sky_scale;
    return sky_scale * textureLod(sky_image, direction_to_equirect(sky_image_from_world * direction), 0.0).rgb;
}
